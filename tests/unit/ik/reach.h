// A limb of noise, and where its joints are in double precision.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "support/double_math.h"
#include "support/rig.h"

namespace marrow::test {

inline Vec3 plus(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 times(const Vec3& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
inline Vec3 origin_of(const Map& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}
inline Vec3 random_vector(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}
inline Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v = random_vector(random, 1);
    if (length(v) > 0.1 && length(v) < 1) return normalised(v);
  }
}
// The direction less its part along the unit vector `axis`.
inline Vec3 across(const Vec3& v, const Vec3& axis) {
  return minus(v, times(axis, dot(v, axis)));
}

// A chain of joints, one below the other, with its pose.
struct Chain {
  explicit Chain(const std::vector<TestJoint>& joints, const Map& above = {})
      : test(joints, {above}), skeleton(test.view()), local(test.rest), scene(skeleton.joint_count) {
    update();
  }
  void update() { EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok); }
  Pose pose() { return {skeleton, local, scene}; }
  // model_from_joint of the pose as it is now.
  std::vector<Map> maps() const {
    std::vector<Map> out;
    for (std::uint32_t i = 0; i < skeleton.joint_count; ++i) {
      const TestJoint j = joint_of(local.data(), i);
      out.push_back((i == 0 ? test.above[0] : out.back()) * from_trs(j.translation, normalised(j.rotation), j.scale));
    }
    return out;
  }

  TestSkeleton test;
  Skeleton skeleton;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
};

inline TestJoint random_joint(Random& random, int parent, const Vec3& scale = {1, 1, 1}) {
  TestJoint j;
  j.parent = parent;
  j.translation = random_vector(random, 1);
  j.rotation = random.rotation();
  j.scale = scale;
  return j;
}

inline void put(float (&to)[3], const Vec3& v) {
  for (std::size_t i = 0; i < 3; ++i) to[i] = static_cast<float>(v[i]);
}
inline Vec3 vec3(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

}  // namespace marrow::test
