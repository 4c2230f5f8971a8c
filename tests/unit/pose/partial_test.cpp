// Parts of local_to_model: a prefix of the joints, and what hangs below one joint.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow {
namespace {

constexpr float kUntouched = -77.0f;

Affine untouched() {
  Affine a;
  for (auto& row : a.rows)
    for (float& f : row) f = kUntouched;
  return a;
}

bool same(const Affine& a, const Affine& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(Partial, APrefixHasTheSameBitsAndLeavesTheRest) {
  int cases = 0;
  for (std::size_t count = 2; count <= 23; ++count) {
    const test::TestCharacter c = test::make_character(count, count, 1, false);
    const Skeleton skeleton = c.skeleton.view();
    std::vector<Affine> whole(count);
    ASSERT_EQ(local_to_model(skeleton, c.skeleton.rest, whole), Status::ok);
    for (std::uint32_t some = 0; some <= count; ++some) {
      std::vector<Affine> out(count, untouched());
      const std::vector<SoaTransform> local(c.skeleton.rest.begin(),
                                            c.skeleton.rest.begin() + static_cast<std::ptrdiff_t>(soa_count(some)));
      ASSERT_EQ(local_to_model_first(skeleton, local, some, {out.data(), some}), Status::ok);
      for (std::size_t j = 0; j < count; ++j, ++cases) {
        EXPECT_TRUE(same(out[j], j < some ? whole[j] : untouched())) << some << " of " << count << ", joint " << j;
      }
    }
  }
  EXPECT_EQ(cases, 4598);  // Σ n (n + 1) for n = 2 … 23
}

bool hangs_below(const test::TestSkeleton& skeleton, std::size_t joint, std::size_t above) {
  while (joint != above && skeleton.joints[joint].parent >= 0)
    joint = static_cast<std::size_t>(skeleton.joints[joint].parent);
  return joint == above;
}

TEST(Partial, BelowAJointAndNothingElse) {
  int changed = 0, kept = 0;
  for (std::size_t count = 2; count <= 40; count += 3) {
    const test::TestCharacter c = test::make_character(100 + count, count, 1, false);
    const Skeleton skeleton = c.skeleton.view();
    std::vector<Affine> whole(count);
    ASSERT_EQ(local_to_model(skeleton, c.skeleton.rest, whole), Status::ok);
    for (std::uint32_t joint = 0; joint < count; ++joint) {
      std::vector<Affine> out = whole;
      for (std::size_t j = 0; j < count; ++j)
        if (hangs_below(c.skeleton, j, joint)) out[j] = untouched();
      ASSERT_EQ(local_to_model_below(skeleton, c.skeleton.rest, joint, out), Status::ok);
      for (std::size_t j = 0; j < count; ++j) EXPECT_TRUE(same(out[j], whole[j])) << j << " below " << joint;
      // And nothing beside them is written.
      std::vector<SoaTransform> moved = c.skeleton.rest;
      for (SoaTransform& t : moved) t.translation[0][0] += 1, t.translation[0][3] -= 1;
      ASSERT_EQ(local_to_model_below(skeleton, moved, joint, out), Status::ok);
      for (std::size_t j = 0; j < count; ++j) {
        if (hangs_below(c.skeleton, j, joint)) {
          ++changed;
        } else {
          ++kept;
          EXPECT_TRUE(same(out[j], whole[j])) << j << " beside " << joint;
        }
      }
    }
  }
  EXPECT_GT(changed, 500);
  EXPECT_GT(kept, 5000);
}

TEST(Partial, BadCalls) {
  const test::TestCharacter c = test::make_character(5, 9, 1, false);
  const Skeleton skeleton = c.skeleton.view();
  const Span<const SoaTransform> local = c.skeleton.rest;
  std::vector<Affine> out(9);
  EXPECT_EQ(local_to_model_first(skeleton, local, 10, out), Status::bad_argument);
  EXPECT_EQ(local_to_model_first(skeleton, {local.data, 2}, 9, out), Status::bad_argument);
  EXPECT_EQ(local_to_model_first(skeleton, local, 9, {out.data(), 8}), Status::bad_argument);
  EXPECT_EQ(local_to_model_first(skeleton, {}, 0, {}), Status::ok);
  EXPECT_EQ(local_to_model_below(skeleton, local, 9, out), Status::bad_argument);
  EXPECT_EQ(local_to_model_below(skeleton, {local.data, 2}, 0, out), Status::bad_argument);
  EXPECT_EQ(local_to_model_below(skeleton, local, 8, {out.data(), 8}), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
