// load: the rules of helpers, broken one at a time in a golden file.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/bad_numbers.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;

class LoadHelpers : public ::testing::Test {
 protected:
  explicit LoadHelpers(test::AlignedBlock (*copy)() = test::golden_half_joint_copy) : block_(copy()) {
    File original;
    EXPECT_EQ(load(block_, original), Status::ok);
    for (const File::Section& s : original.sections())
      if (s.type == format::kTypes[format::kMeshes]) mesh_ = s;
    format::MeshHeader header;
    std::memcpy(&header, block_.data() + mesh_.offset, sizeof header);
    first_ = mesh_.offset + layout(header).helpers;
    end_ = mesh_.offset + layout(header).lods;
    EXPECT_EQ(end_, std::size_t{mesh_.offset} + mesh_.bytes);
  }
  template <class T>
  void refuse_as(test::AlignedBlock& block, const char* rule, std::size_t place, std::size_t offset, T value,
                 const char* what) {
    const test::DamageReport got = test::load_with(block, offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_EQ(got.mesh_count, 0u) << what;
    EXPECT_STREQ(got.error.rule, rule) << what;
    EXPECT_EQ(got.error.offset, place) << what;
    ++refused_;
  }
  // Two that are the same are told at the helper, and so is its first; the others where they stand.
  template <class T>
  void refuse(std::size_t place, std::size_t offset, T value, const char* what) {
    refuse_as(block_, "a helper blends two joints of the mesh", place, offset, value, what);
  }

  test::AlignedBlock block_;
  File::Section mesh_{};
  std::size_t first_ = 0, end_ = 0;  // of helpers and centres
  int refused_ = 0;
};

struct LoadCentres : LoadHelpers {
  LoadCentres() : LoadHelpers(test::golden_centres_copy) {}
};

TEST_F(LoadHelpers, BlendTwoJoints) {
  refuse(first_, first_, std::uint16_t{1}, "its first is its second");
  refuse(first_, first_ + 2, std::uint16_t{0}, "its second is its first");
  refuse(first_, first_, std::uint16_t{2}, "its first is a helper");
  refuse(first_, first_, std::uint16_t{0xFFFF}, "a first out of range");
  refuse(first_ + 2, first_ + 2, std::uint16_t{2}, "its second is a helper");
  refuse(first_ + 2, first_ + 2, std::uint16_t{0xFFFF}, "a second out of range");
  for (const float share : {0.0f, -0.0f, 1.0f, -0.5f, 1.5f, kInfinity, -kInfinity, kNan})
    refuse(first_ + 4, first_ + 4, share, "a share that is not between");
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

TEST_F(LoadCentres, AreNumbersOfSaneSize) {
  ASSERT_EQ(end_ - first_, sizeof(Helper) + 12);
  for (std::size_t at = end_ - 12; at < end_; at += 4)
    for (const float c : {kNan, kInfinity, -kInfinity, 1.001e12f, -3e38f})
      refuse_as(block_, "a number that is not finite, or beyond 1e12", at, at, c, "a centre");
  EXPECT_EQ(refused_, 15);
  EXPECT_EQ(test::load_with(block_, end_ - 12, -1e12f).status, Status::ok);
  refuse(first_ + 4, first_ + 4, 1.0f, "a share that is not between");
}

TEST_F(LoadCentres, AreThereOrNot) {
  constexpr const char* kRule = "section size differs from its counts";
  const std::size_t flags = mesh_.offset + 20;
  for (const unsigned wrong : {0u, 2u, 3u})
    refuse_as(block_, kRule, mesh_.offset, flags, static_cast<std::uint8_t>(wrong), "no flag");
  test::AlignedBlock none = test::golden_half_joint_copy();
  refuse_as(none, kRule, mesh_.offset, flags, std::uint8_t{4}, "no centres");
  test::AlignedBlock plain = test::golden_copy();
  File without;
  ASSERT_EQ(load(plain, without), Status::ok);
  for (const File::Section& s : without.sections())
    if (s.type == format::kTypes[format::kMeshes])
      refuse_as(plain, "centres without helpers", s.offset + 20, s.offset + 20, std::uint8_t{4}, "no helpers");
  EXPECT_GT(refused_, 4);
}

}  // namespace
}  // namespace marrow
