// Limbs whose start joint, or what is above them, is scaled unevenly: they change their shape as they turn.
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "unit/ik/limb.h"

namespace marrow {
namespace {

using test::Chain;
using test::joint_of;
using test::kLimb;
using test::length;
using test::minus;
using test::normalised;
using test::Places;
using test::plus;
using test::put;
using test::random_limb;
using test::times;

// A limb whose start joint, or what is above, is scaled unevenly; `most` to 1.
Chain uneven_limb(test::Random& random, double most, int kind) {
  std::vector<test::TestJoint> joints = random_limb(random).test.joints;
  for (std::size_t j = 0; j < 2; ++j)
    if (kind == 2 || kind == static_cast<int>(j))
      for (double& s : joints[j].scale) s *= random.between(1 / most, most);
  return Chain(joints);
}

TEST(UnevenLimb, IsMet) {
  test::Random random(8);
  int cases = 0, off = 0;
  double worst[3] = {}, mean = 0;
  for (int i = 0; i < 6000; ++i) {
    Chain c = uneven_limb(random, 1.25, i % 3);
    const Places was(c);
    TwoBone goal;
    put(goal.target, plus(was.start, times(test::random_direction(random), was.limb * random.between(0.5, 0.8))));
    if (i % 2 == 0) put(goal.pole, test::random_direction(random));
    bool reached = false;
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
    if (!reached) continue;
    const double miss = length(minus(Places(c).end, test::vec3(goal.target))) / was.limb;
    worst[i % 3] = std::fmax(worst[i % 3], miss);
    mean += miss;
    off += miss > 1e-5;
    ++cases;
  }
  EXPECT_GT(cases, 5700);
  EXPECT_LT(worst[0], 2e-6);  // above alone: in closed form
  EXPECT_LT(mean / cases, 1e-6);
  EXPECT_LT(off, cases / 200);
  std::printf("uneven scale: off by %.2g of the limb, at worst %.2g above, %.2g own, %.2g both; %d of %d by 1e-5\n",
              mean / cases, worst[0], worst[1], worst[2], off, cases);
}

// Folded as for a target beside it, and `reached` says whether that is enough.
TEST(UnevenLimb, ATargetAtTheStartJointFolds) {
  test::Random random(9);
  int cases = 0;
  for (int i = 0; i < 600; ++i) {
    const Chain before = uneven_limb(random, 1.25, i % 3);
    const Places was(before);
    double miss[2];
    for (int k = 0; k < 2; ++k) {
      Chain c = before;
      c.skeleton = c.test.view();
      TwoBone goal;
      put(goal.target, plus(was.start, times(normalised(minus(was.end, was.start)), k * 1e-3 * was.limb)));
      bool reached = false;
      ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
      miss[k] = length(minus(Places(c).end, test::vec3(goal.target))) / was.limb;
      EXPECT_EQ(reached, miss[k] < 1e-4) << i;
    }
    EXPECT_LT(miss[0], 1.25 * 1.25 * miss[1] + 2e-3) << i << ": by how much the way there may be stretched";
    ++cases;
  }
  EXPECT_EQ(cases, 600);
}

// However unevenly it is scaled, and where what is above is flat.
TEST(UnevenLimb, SaysWhetherItIsMet) {
  test::Random random(8);
  int met = 0, cases = 0;
  for (; cases < 20000; ++cases) {
    Chain c = uneven_limb(random, 4, 2);
    if (cases % 10 == 0) {
      std::vector<test::TestJoint> joints = c.test.joints;
      joints[0].scale[random.below(3)] = 0;
      c = Chain(joints);
    }
    const Places was(c);
    TwoBone goal;
    put(goal.target, plus(was.start, times(test::random_direction(random), was.limb * random.between(0.2, 0.9))));
    bool reached = false;
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
    if (!reached) continue;
    const Places is(c);
    EXPECT_LT(length(minus(is.end, test::vec3(goal.target))), 1.1e-4 * is.limb) << cases;
    ++met;
  }
  EXPECT_GT(met, 5000);
}

// The start joint's own scale makes up for that above, as long as it is not turned.
TEST(UnevenLimb, ThatThePoseHidesIsMetToo) {
  std::vector<test::TestJoint> joints(4);
  for (int i = 0; i < 4; ++i) joints[static_cast<std::size_t>(i)].parent = i - 1;
  joints[0].scale = {1, 2, 1};
  joints[1].scale = {1, 0.5, 1};
  joints[2].translation = {0.5, 0, 0};
  joints[2].rotation = normalised(test::Quat{0, 0, 1, 1});
  joints[3].translation = {0.4, 0, 0};
  Chain c(joints);
  TwoBone goal;
  put(goal.target, {0.3, 0.4, 0.3});
  bool reached = false;
  ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
  EXPECT_TRUE(reached);
  EXPECT_LT(length(minus(Places(c).end, test::vec3(goal.target))), 2e-6);
}

// A weight blends the turns, and makes no jump where it becomes 1.
TEST(UnevenLimb, ByWeight) {
  test::Random random(9);
  for (int i = 0; i < 300; ++i) {
    const Chain before = uneven_limb(random, 2, i % 3);
    const Places was(before);
    TwoBone goal;
    put(goal.target, plus(was.start, times(test::random_direction(random), was.limb * random.between(0.2, 1.2))));
    const auto at = [&](float weight) {
      Chain c = before;
      c.skeleton = c.test.view();
      goal.weight = weight;
      EXPECT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
      return c;
    };
    const Chain whole = at(1), nearly = at(0.99999f), half = at(0.5f);
    EXPECT_LT(length(minus(Places(whole).end, Places(nearly).end)), 1e-3 * was.limb) << i;
    for (std::size_t j = 1; j < 3; ++j) {
      const test::Quat from = joint_of(before.local.data(), j).rotation, to = joint_of(whole.local.data(), j).rotation;
      const double side = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3] < 0 ? -1 : 1;
      test::Quat between;
      for (std::size_t k = 0; k < 4; ++k) between[k] = from[k] + side * to[k];
      between = normalised(between);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(joint_of(half.local.data(), j).rotation[k], between[k], 1e-5) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace marrow
