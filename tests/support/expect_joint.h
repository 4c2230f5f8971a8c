// How tests compare joints of poses that are not the same bits.
#pragma once

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow::test {

// A quaternion and its negative are the same rotation.
inline void expect_joint(const TestJoint& got, const TestJoint& want, double tolerance) {
  double cosine = 0;
  for (std::size_t i = 0; i < 4; ++i) cosine += got.rotation[i] * want.rotation[i];
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(got.translation[i], want.translation[i], tolerance) << "translation " << i;
    EXPECT_NEAR(got.scale[i], want.scale[i], tolerance) << "scale " << i;
  }
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(got.rotation[i], cosine < 0 ? -want.rotation[i] : want.rotation[i], tolerance) << "rotation " << i;
}

}  // namespace marrow::test
