// load: the rules of helpers, broken one at a time in a golden file.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

class LoadHelpers : public ::testing::Test {
 protected:
  LoadHelpers() : block_(test::golden_half_joint_copy()) {
    File original;
    EXPECT_EQ(load(block_, original), Status::ok);
    for (const File::Section& s : original.sections())
      if (s.type == format::kTypes[format::kMeshes]) mesh_ = s;
    format::MeshHeader header;
    std::memcpy(&header, block_.data() + mesh_.offset, sizeof header);
    first_ = mesh_.offset + layout(header).helpers;
    EXPECT_EQ(first_ + sizeof(Helper), std::size_t{mesh_.offset} + mesh_.bytes);
  }
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    const test::DamageReport got = test::load_with(block_, offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_EQ(got.mesh_count, 0u) << what;
    EXPECT_STREQ(got.error.rule, "a helper blends two joints of the mesh") << what;
    EXPECT_EQ(got.error.offset, first_) << what;
    ++refused_;
  }

  test::AlignedBlock block_;
  File::Section mesh_{};
  std::size_t first_ = 0;
  int refused_ = 0;
};

TEST_F(LoadHelpers, BlendTwoJoints) {
  refuse(first_, std::uint16_t{1}, "its first is its second");
  refuse(first_ + 2, std::uint16_t{0}, "its second is its first");
  refuse(first_, std::uint16_t{2}, "its first is a helper");
  refuse(first_, std::uint16_t{0xFFFF}, "a first out of range");
  refuse(first_ + 2, std::uint16_t{2}, "its second is a helper");
  refuse(first_ + 2, std::uint16_t{0xFFFF}, "a second out of range");
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float share :
       {0.0f, -0.0f, 1.0f, -0.5f, 1.5f, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()})
    refuse(first_ + 4, share, "a share that is not between");
  EXPECT_EQ(refused_, 14);
}

TEST_F(LoadHelpers, MayLieAnywhereBetween) {
  for (const float share : {std::numeric_limits<float>::denorm_min(), 0.25f, std::nextafter(1.0f, 0.0f)})
    EXPECT_EQ(test::load_with(block_, first_ + 4, share).status, Status::ok) << share;
}

TEST_F(LoadHelpers, AreAsManyAsThePaletteLeavesAndTheSectionHolds) {
  int refused = 0;
  for (const int count : {0, 2, 3, 0xFFFF}) {
    const test::DamageReport got = test::load_with(block_, mesh_.offset + 22, static_cast<std::uint16_t>(count));
    EXPECT_EQ(got.status, Status::bad_data) << count;
    EXPECT_GE(got.error.offset, std::size_t{mesh_.offset}) << count;
    EXPECT_LT(got.error.offset, first_) << count;
    ++refused;
  }
  EXPECT_EQ(refused, 4);
}

}  // namespace
}  // namespace marrow
