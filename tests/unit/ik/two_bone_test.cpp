// A limb of two bones against closed forms in double precision.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/expect_joint.h"
#include "support/poses.h"
#include "unit/ik/limb.h"

namespace marrow {
namespace {

using test::Chain;
using test::cross;
using test::dot;
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
using test::Vec3;

// Where middle and end joint are to be: the law of cosines in the plane of target and pole.
struct Wanted {
  Wanted(const Places& was, const Vec3& target, const Vec3& pole) {
    const Vec3 way = normalised(minus(target, was.start)), side = normalised(test::across(pole, way));
    const double reach =
        std::fmin(std::fmax(length(minus(target, was.start)), std::fabs(was.upper - was.lower)), was.limb);
    const double cosine = (was.upper * was.upper + reach * reach - was.lower * was.lower) / (2 * was.upper * reach);
    along = was.upper * cosine;
    aside = was.upper * std::sqrt(std::fmax(0, 1 - cosine * cosine));
    end = plus(was.start, times(way, reach));
    mid = plus(was.start, plus(times(way, along), times(side, aside)));
  }
  Vec3 mid, end;
  double along, aside;
};

TEST(TwoBone, EqualsTheLawOfCosines) {
  test::Random random(1);
  int cases = 0, reached = 0;
  double worst_end = 0, worst_mid = 0;
  for (int i = 0; i < 100000; ++i) {
    Chain c = random_limb(random, i % 4 == 0);
    const Places was(c);
    const Vec3 way = test::random_direction(random), pole = test::random_direction(random);
    if (length(cross(way, pole)) < 0.11 || std::fmin(was.upper, was.lower) < 0.02 * was.limb) continue;
    TwoBone goal;
    put(goal.target, plus(was.start, times(way, was.limb * random.between(0.05, 1.2))));
    put(goal.pole, times(pole, random.between(0.1, 10)));
    if (i % 2 == 0) put(goal.bend_axis, times(test::random_direction(random), random.between(0.5, 2)));
    bool got_there = false;
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &got_there), Status::ok);
    const Places now(c);
    const Wanted want(was, test::vec3(goal.target), test::vec3(goal.pole));
    const double end = length(minus(now.end, want.end)) / was.limb;
    // Where the limb is all but stretched, how far the middle joint is aside hangs on the last bits of the lengths.
    const double mid = length(minus(now.mid, want.mid)) / was.limb / (1 + 1e-2 * was.limb / (want.aside + 1e-9));
    worst_end = std::fmax(worst_end, end);
    worst_mid = std::fmax(worst_mid, mid);
    EXPECT_LT(end, 1e-4) << i;
    EXPECT_LT(mid, 1e-4) << i;
    EXPECT_EQ(got_there, length(minus(want.end, test::vec3(goal.target))) < 1e-4 * was.limb) << i;
    reached += got_there;
    ++cases;
  }
  EXPECT_GT(cases, 95000);
  EXPECT_GT(reached, 50000);
  std::printf("end %.2g, middle %.2g of the limb; %d cases, %d reached\n", worst_end, worst_mid, cases, reached);
}

TEST(TwoBone, FourAtOnceAreTheSameNumbers) {
  test::Random random(4);
  int cases = 0;
  for (int i = 0; i < 5000; ++i) {
    std::vector<Chain> limbs;
    TwoBone goals[4];
    TwoBoneJoints joints[4];
    for (int k = 0; k < 4; ++k) {
      limbs.push_back(random_limb(random, k == 3));
      const Places was(limbs.back());
      TwoBone& goal = goals[k];
      put(goal.target, plus(was.start, times(test::random_direction(random), was.limb * random.between(0.05, 1.2))));
      // Of some, the four want all that there is; of others, some do or none.
      if (random.below(4) < static_cast<std::uint32_t>(i % 5)) put(goal.pole, test::random_direction(random));
      if (random.below(4) < static_cast<std::uint32_t>(i % 3)) put(goal.bend_axis, test::random_direction(random));
      if (random.below(8) < static_cast<std::uint32_t>(i % 7)) goal.weight = static_cast<float>(random.between(0, 1));
      if (random.below(8) < static_cast<std::uint32_t>(i % 4)) goal.soft = static_cast<float>(random.between(0, 1));
      if (random.below(8) < static_cast<std::uint32_t>(i % 6))
        goal.twist_rad = static_cast<float>(random.between(-9, 9));
      if (random.below(8) < static_cast<std::uint32_t>(i % 9)) goal.max_stretch = 1.25f;
      if (i % 50 == k) put(goal.target, was.start);
    }
    if (i % 10 == 0) {  // one of a joint's axes has no length, or hardly any
      const float length = i % 20 == 0 ? 0.0f : 1e-20f;
      Affine& m = limbs[random.below(4)].scene[1 + random.below(2)];
      const std::uint32_t axis = random.below(3);
      for (float(&row)[4] : m.rows) row[axis] *= length;
    }
    for (std::size_t k = 0; k < 4; ++k) joints[k] = {&limbs[k].scene[1], &limbs[k].scene[2], &limbs[k].scene[3]};
    TwoBoneTurns four[4];
    ASSERT_EQ(two_bone_x4(joints, goals, four), Status::ok);
    for (std::size_t k = 0; k < 4; ++k) {
      TwoBoneTurns one;
      ASSERT_EQ(two_bone(joints[k], goals[k], one), Status::ok);
      for (std::size_t n = 0; n < 4; ++n) {
        EXPECT_EQ(four[k].start[n], one.start[n]) << i << " " << k;
        EXPECT_EQ(four[k].mid[n], one.mid[n]) << i << " " << k;
      }
      EXPECT_EQ(four[k].stretch, one.stretch);
      EXPECT_EQ(four[k].reached, one.reached);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 20000);
}

TEST(TwoBone, ScalesOfTheMiddleJointItselfAreExact) {
  test::Random random(5);
  int cases = 0;
  for (int i = 0; i < 10000; ++i) {
    Chain c = random_limb(random, i % 3 == 0);
    std::vector<test::TestJoint> joints = c.test.joints;
    for (double& s : joints[2].scale) s = random.between(0.5, 2) * (random.below(2) == 0 ? -1 : 1);
    const double mirrored = random.below(2) == 0 ? -1 : 1;
    for (double& s : joints[1].scale) s *= mirrored;
    Chain scaled(joints, c.test.above[0]);
    const Places was(scaled);
    const Vec3 way = test::random_direction(random), pole = test::random_direction(random);
    if (length(cross(way, pole)) < 0.11 || std::fmin(was.upper, was.lower) < 0.02 * was.limb) continue;
    TwoBone goal;
    put(goal.target, plus(was.start, times(way, was.limb * random.between(0.05, 1.2))));
    put(goal.pole, pole);
    ASSERT_EQ(solve_two_bone(scaled.pose(), kLimb, goal), Status::ok);
    const Places now(scaled);
    const Wanted want(was, test::vec3(goal.target), pole);
    EXPECT_LT(length(minus(now.end, want.end)), 1e-4 * was.limb) << i;
    ++cases;
  }
  EXPECT_GT(cases, 9500);
}

// An arm along x with a right angle at the elbow, in the plane of x and y; what hangs below is 0.2 from the end.
Chain plain_arm(double scale = 1) {
  std::vector<test::TestJoint> joints(5);
  for (int i = 0; i < 5; ++i) joints[static_cast<std::size_t>(i)].parent = i - 1;
  joints[1].scale = {scale, scale, scale};
  joints[2].translation = {0.5, 0, 0};
  joints[2].rotation = normalised(test::Quat{0, 0, 1, 1});
  joints[3].translation = {0.4, 0, 0};
  joints[4].translation = {0.2, 0.1, 0};
  return Chain(joints);
}

bool all_finite(const Chain& c) {
  for (const Affine& a : c.scene)
    for (const auto& row : a.rows)
      for (const float x : row)
        if (!std::isfinite(x)) return false;
  for (std::size_t i = 0; i < c.skeleton.joint_count; ++i) {
    const test::Quat q = joint_of(c.local.data(), i).rotation;
    if (!(std::fabs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-5)) return false;
  }
  return true;
}

TEST(TwoBone, NothingDegenerateBecomesInfinite) {
  const Vec3 bones[] = {{0, 0, 0}, {0.5, 0, 0}, {-0.5, 0, 0}, {0.3, 1e-4, 0}, {1e-12, 0, 0}, {0, 0, 0.5}};
  const Vec3 scales[] = {{1, 1, 1}, {0, 0, 0}, {1, 0, 2}, {-1, 1, 3}, {1e-3, 1e-3, 1e-3}};
  const Vec3 targets[] = {{0, 0, 0},    {0.5, 0, 0}, {1, 0, 0},    {-1, 0, 0},
                          {-0.2, 0, 0}, {1e6, 0, 0}, {0, 1e-9, 0}, {0.3, 0.4, 0}};
  const Vec3 directions[] = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1e-12, 0}, {1, 1e-5, 0}};
  int cases = 0;
  for (const Vec3& upper : bones) {
    for (const Vec3& lower : bones) {
      for (const Vec3& scale : scales) {
        std::vector<test::TestJoint> joints(5);
        for (int i = 0; i < 5; ++i) joints[static_cast<std::size_t>(i)].parent = i - 1;
        joints[1].scale = scale;
        joints[2].scale = scale;
        joints[2].translation = upper;
        joints[3].translation = lower;
        const Chain before(joints);
        for (const Vec3& target : targets) {
          for (const Vec3& pole : directions) {
            for (const Vec3& axis : directions) {
              TwoBone goal;
              put(goal.target, target);
              put(goal.pole, pole);
              put(goal.bend_axis, axis);
              goal.soft = cases % 2 == 0 ? 1.0f : 0.9f;
              goal.max_stretch = cases % 3 == 0 ? 1.5f : 1.0f;
              goal.weight = cases % 5 == 0 ? 0.5f : 1.0f;
              Chain c = before;
              c.skeleton = c.test.view();
              ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok) << cases;
              EXPECT_TRUE(all_finite(c)) << cases;
              ++cases;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 6 * 6 * 5 * 8 * 6 * 6);
}

TEST(TwoBone, CollinearAndFoldedLimbsReach) {
  int cases = 0;
  for (const double lower : {0.4, -0.4, 0.5, -0.5}) {  // straight, folded
    for (const Vec3& axis : {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
      for (const Vec3& pole : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0.6, 0.64, 0.48}}) {
        for (const Vec3& target : {Vec3{0.6, 0, 0}, Vec3{-0.6, 0, 0}, Vec3{0, 0.6, 0}, Vec3{0.3, 0.32, 0.24}}) {
          std::vector<test::TestJoint> joints = plain_arm().test.joints;
          joints[2].rotation = {0, 0, 0, 1};
          joints[3].translation[0] = lower;
          Chain c(joints);
          TwoBone goal;
          put(goal.target, target);
          put(goal.pole, pole);
          put(goal.bend_axis, axis);
          bool reached = false;
          ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
          EXPECT_TRUE(reached);
          EXPECT_LT(length(minus(Places(c).end, target)), 1e-5) << cases;
          ++cases;
        }
      }
    }
  }
  EXPECT_EQ(cases, 256);
}

// No nearer than the difference of the bones' lengths, whatever the limb was like; and no way leads there.
TEST(TwoBone, ATargetAtTheStartJointFolds) {
  int cases = 0;
  for (const double lower : {0.5, 0.45, 0.3, 0.7})
    for (const double bend : {0.0, 1e-4, 0.4, 1.5707963, 3.1}) {
      for (const Vec3& axis : {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
        for (const double away : {0.0, 1e-20, 1e-6}) {
          std::vector<test::TestJoint> joints = plain_arm().test.joints;
          joints[2].rotation = test::axis_angle({0, 0, 1}, bend);
          joints[3].translation[0] = lower;
          Chain c(joints);
          TwoBone goal;
          put(goal.target, {0, away, 0});
          put(goal.bend_axis, axis);
          bool reached = lower != 0.5;
          ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
          EXPECT_EQ(reached, lower == 0.5) << cases;
          const Places now(c);
          EXPECT_NEAR(length(minus(now.end, now.start)), std::fabs(0.5 - lower), 3e-6) << cases;
          ++cases;
        }
      }
    }
  EXPECT_EQ(cases, 4 * 5 * 3 * 3);
}

TEST(TwoBone, PreferredBend) {
  int cases = 0;
  for (const double angle : {-60.0, -3.0, -0.001, 0.0, 0.001, 3.0, 60.0}) {
    std::vector<test::TestJoint> joints = plain_arm().test.joints;
    joints[2].rotation = test::axis_angle({0, 0, 1}, angle / 57.29577951308232);
    for (const double side : {-1.0, 1.0}) {
      Chain c(joints);
      TwoBone goal;
      put(goal.target, {0.6, 0, 0});
      goal.bend_axis[2] = static_cast<float>(side);
      ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
      // The elbow's own rotation, about z, is to the preferred side, whatever it was.
      const test::Quat q = joint_of(c.local.data(), 2).rotation;
      EXPECT_GT(q[2] * q[3] * side, 0.1) << angle << " " << side;
      EXPECT_NEAR(q[0], 0, 1e-4);
      EXPECT_NEAR(q[1], 0, 1e-4);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 14);
}

TEST(TwoBone, WithoutAPoleAReachedTargetChangesNothing) {
  test::Random random(6);
  int cases = 0;
  for (int i = 0; i < 2000; ++i) {
    Chain c = random_limb(random);
    const Places was(c);
    const std::vector<SoaTransform> before = c.local;
    TwoBone goal;
    put(goal.target, was.end);
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
    // Where straight or folded, angles hang on the last bits of the lengths.
    if (length(cross(minus(was.mid, was.start), minus(was.end, was.mid))) < 0.05 * was.upper * was.lower) continue;
    for (std::size_t j = 1; j < 3; ++j)
      test::expect_joint(joint_of(c.local.data(), j), joint_of(before.data(), j), 2e-4);
    ++cases;
  }
  EXPECT_GT(cases, 1500);
}

TEST(TwoBone, TwistTurnsTheMiddleJointAboutTheLineToTheTarget) {
  int cases = 0;
  for (const double degrees : {-400.0, -180.0, -30.0, 90.0, 180.0, 270.0}) {
    for (const Vec3& pole : {Vec3{0, 0, 0}, Vec3{0, -1, 0}}) {  // where the elbow is anyway
      Chain c = plain_arm();
      TwoBone goal;
      put(goal.target, {0.6, 0, 0});
      put(goal.pole, pole);
      Chain straight = plain_arm();
      ASSERT_EQ(solve_two_bone(straight.pose(), kLimb, goal), Status::ok);
      goal.twist_rad = static_cast<float>(degrees / 57.29577951308232);
      ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
      const Vec3 from = Places(straight).mid, to = Places(c).mid;
      const double cosine = std::cos(degrees / 57.29577951308232), sine = std::sin(degrees / 57.29577951308232);
      EXPECT_NEAR(to[0], from[0], 1e-5);
      EXPECT_NEAR(to[1], from[1] * cosine - from[2] * sine, 1e-5) << degrees;
      EXPECT_NEAR(to[2], from[1] * sine + from[2] * cosine, 1e-5) << degrees;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST(TwoBone, StretchReachesUpToItsLimit) {
  int cases = 0;
  for (const float soft : {1.0f, 0.95f}) {
    for (const double reach : {0.5, 0.86, 0.9, 1.0, 1.1, 1.2}) {  // of a limb of 0.9, that can be 1.08
      Chain c = plain_arm(2);
      TwoBone goal;
      put(goal.target, {0, 2 * reach, 0});
      goal.soft = soft;
      goal.max_stretch = 1.2f;
      bool reached = false;
      ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal, &reached), Status::ok);
      const Places now(c);
      EXPECT_EQ(reached, reach < 1.08) << reach;
      if (reached) {
        EXPECT_NEAR(now.end[1], 2 * reach, 1e-5);
      }
      EXPECT_LE(now.limb, 2 * 1.08 + 1e-5);
      EXPECT_NEAR(now.upper / now.lower, 5.0 / 4, 1e-5);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST(TwoBone, WeightZeroChangesNoBitAndHalfIsHalfTheTurn) {
  test::Random random(7);
  for (int i = 0; i < 100; ++i) {
    Chain c = random_limb(random);
    const std::vector<SoaTransform> local = c.local;
    const std::vector<Affine> scene = c.scene;
    TwoBone goal;
    put(goal.target, test::random_vector(random, 2));
    goal.weight = 0;
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
    EXPECT_EQ(std::memcmp(local.data(), c.local.data(), local.size() * sizeof local[0]), 0);
    EXPECT_EQ(std::memcmp(scene.data(), c.scene.data(), scene.size() * sizeof scene[0]), 0);
    TwoBoneTurns whole, half;
    goal.weight = 1;
    ASSERT_EQ(two_bone({&c.scene[1], &c.scene[2], &c.scene[3]}, goal, whole), Status::ok);
    goal.weight = 0.5f;
    ASSERT_EQ(two_bone({&c.scene[1], &c.scene[2], &c.scene[3]}, goal, half), Status::ok);
    // cos² of a quarter of the angle is half of 1 + cos of its half.
    EXPECT_NEAR(2 * half.start[3] * half.start[3], 1 + whole.start[3], 1e-5);
    EXPECT_NEAR(2 * half.mid[3] * half.mid[3], 1 + whole.mid[3], 1e-5);
  }
}

TEST(TwoBone, BadCallsAreRefusedAndWriteNothing) {
  Chain c = plain_arm();
  const std::vector<SoaTransform> local = c.local;
  TwoBone good;
  put(good.target, {0.5, 0.2, 0.1});
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  int cases = 0;
  const auto refused = [&](const TwoBone& goal, const TwoBoneLimb& limb = kLimb) {
    bool reached = true;
    EXPECT_EQ(solve_two_bone(c.pose(), limb, goal, &reached), Status::bad_argument) << cases;
    EXPECT_TRUE(reached);
    EXPECT_EQ(std::memcmp(local.data(), c.local.data(), local.size() * sizeof local[0]), 0);
    TwoBoneTurns out[4];
    if (limb.start == kLimb.start && limb.mid == kLimb.mid && limb.end == kLimb.end) {
      const TwoBoneJoints j = {&c.scene[1], &c.scene[2], &c.scene[3]};
      EXPECT_EQ(two_bone_x4({j, j, j, j}, {good, good, goal, good}, out), Status::bad_argument) << cases;
      EXPECT_EQ(out[0].start[3], 1);
      EXPECT_EQ(out[2].mid[3], 1);
    }
    ++cases;
  };
  for (const float bad : {nan, infinite, -infinite, 1e30f}) {
    for (int i = 0; i < 3; ++i) {
      for (float(TwoBone::*const member)[3] : {&TwoBone::target, &TwoBone::pole, &TwoBone::bend_axis}) {
        if (bad == 1e30f && member == &TwoBone::bend_axis) continue;  // it is not squared where the bend agrees
        TwoBone goal = good;
        (goal.*member)[i] = bad;
        refused(goal);
      }
    }
  }
  for (const float bad : {nan, infinite, -0.01f, 1.01f}) {
    for (float TwoBone::*const member : {&TwoBone::weight, &TwoBone::soft}) {
      TwoBone goal = good;
      goal.*member = bad;
      refused(goal);
    }
  }
  for (const float bad : {nan, infinite, 0.99f, -2.0f}) {
    TwoBone goal = good;
    goal.max_stretch = bad;
    refused(goal);
  }
  for (const float bad : {nan, infinite}) {
    TwoBone goal = good;
    goal.twist_rad = bad;
    refused(goal);
  }
  for (const TwoBoneLimb& limb :
       {TwoBoneLimb{1, 2, 5}, TwoBoneLimb{1, 1, 3}, TwoBoneLimb{2, 1, 3}, TwoBoneLimb{1, 3, 3}, TwoBoneLimb{~0u, 2, 3},
        TwoBoneLimb{1, ~0u, 3}, TwoBoneLimb{1, 2, ~0u}})
    refused(good, limb);
  EXPECT_EQ(cases, 33 + 8 + 4 + 2 + 7);
  EXPECT_EQ(solve_two_bone({c.skeleton, {c.local.data(), c.local.size() - 1}, c.scene}, kLimb, good),
            Status::bad_argument);
  EXPECT_EQ(solve_two_bone({c.skeleton, c.local, {c.scene.data(), c.scene.size() - 1}}, kLimb, good),
            Status::bad_argument);
  c.scene[1].rows[1][1] = nan;
  EXPECT_EQ(solve_two_bone(c.pose(), kLimb, good), Status::bad_argument);
}

// The code of docs/ik.md.
TEST(TwoBone, AsInTheManual) {
  Chain c = plain_arm();
  const Pose pose = c.pose();
  const std::uint32_t thigh = 1, shin = 2, foot = 3;

  TwoBone reach;
  reach.target[0] = 0.3f, reach.target[1] = 0.6f;  // scene, metres
  reach.bend_axis[2] = 1;                          // the knee's hinge, in the shin's own space
  reach.soft = 0.97f;
  bool reached = false;
  Status status = local_to_model(pose.skeleton, pose.local, pose.model_from_joint);
  if (status == Status::ok) status = solve_two_bone(pose, {thigh, shin, foot}, reach, &reached);

  Aim look;
  look.target[0] = 5, look.target[1] = 1;
  look.forward[0] = 1, look.forward[2] = 0;  // along the foot
  const std::uint32_t chain[] = {thigh, shin, foot};
  if (status == Status::ok) status = solve_look_at(pose, {chain, 3}, look, 0.5f);

  EXPECT_EQ(status, Status::ok);
  EXPECT_TRUE(reached);
}

}  // namespace
}  // namespace marrow
