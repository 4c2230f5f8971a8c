// load: bounds of clips and meshes, and what is refused of them.
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/file.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

class LoadBounds : public ::testing::Test {
 protected:
  LoadBounds() : block_(test::golden_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kBounds]) base_ = s.offset;
    EXPECT_NE(base_, 0u);
  }
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << rule;
    EXPECT_STREQ(got.error.rule, rule);
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadBounds, AreIntegersTimesAPowerOfTwo) {
  ASSERT_EQ(file_.clip_count(), 2u);
  ASSERT_EQ(file_.mesh_count(), 2u);
  // -3 · 2⁻², …; a radius of 200 · 2⁻².
  const format::BoundsCodes codes{-2, {-3, 0, 5}, {4, 127, 5}, 200};
  std::memcpy(block_.data() + base_ + sizeof(format::BoundsHeader) + sizeof codes, &codes, sizeof codes);
  test::forge_checksum(block_.data(), block_.size());
  File file;
  ASSERT_EQ(load(block_, file), Status::ok);
  const Bounds b = file.bounds(0, 1);
  const float least[] = {-0.75f, 0, 1.25f}, most[] = {1, 31.75f, 1.25f}, centre[] = {0.125f, 15.875f, 1.25f};
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(b.box_min[c], least[c]);
    EXPECT_EQ(b.box_max[c], most[c]);
    EXPECT_EQ(b.centre(c), centre[c]);
  }
  EXPECT_EQ(b.radius_m, 50);
  EXPECT_FALSE(b.is_empty());
}

TEST_F(LoadBounds, OfWhatIsNotThereAreEmpty) {
  EXPECT_FALSE(file_.bounds(0, 0).is_empty());
  EXPECT_TRUE(file_.bounds(2, 0).is_empty());
  EXPECT_TRUE(file_.bounds(0, 2).is_empty());
  EXPECT_TRUE(File{}.bounds(0, 0).is_empty());
  // Files from before there were any still load.
  const test::AlignedBlock old = test::golden_half_joint_copy();
  File without;
  ASSERT_EQ(load(old, without), Status::ok);
  ASSERT_GT(without.clip_count(), 0u);
  EXPECT_TRUE(without.bounds(0, 0).is_empty());
}

TEST_F(LoadBounds, AreRefusedByTheirRules) {
  refuse(0, std::uint32_t{1}, "no such skeleton");
  refuse(4, std::uint32_t{3}, "section size differs from its counts");
  // Counts whose product wraps, times 8 bytes, to what is there; and two that are right only together.
  const std::uint32_t huge[] = {1824726041, 1263665316};
  static_assert(1824726041ull * 1263665316ull * 8 == 32);
  std::uint64_t both = 0;
  std::memcpy(&both, huge, sizeof both);
  refuse(4, both, "section size differs from its counts");
  const std::uint32_t one_clip[] = {1, 4};
  std::memcpy(&both, one_clip, sizeof both);
  refuse(4, both, "1 to as many as meshes");
  refuse(12, std::int8_t{101}, "no box");
  refuse(12, std::int8_t{-101}, "no box");
  refuse(13, std::int8_t{127}, "no box");
  refuse(20 + 6, std::int8_t{-128}, "no box");
  EXPECT_EQ(refused_, 8);
}

}  // namespace
}  // namespace marrow
