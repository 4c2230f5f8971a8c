// Small movements of targets and poses make small movements of joints; and the same bits on every processor.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "support/pose_file.h"
#include "unit/ik/reach.h"

namespace marrow {
namespace {

using test::Chain;
using test::cross;
using test::dot;
using test::length;
using test::normalised;
using test::plus;
using test::put;
using test::times;
using test::Vec3;

constexpr TwoBoneLimb kLimb = {1, 2, 3};
constexpr double kDegree = 3.14159265358979 / 180;

// An arm of bones 0.5 and 0.4 long, its elbow bent about z by so much.
Chain arm(double bend_degrees, double sideways_degrees = 0) {
  std::vector<test::TestJoint> joints(5);
  for (int i = 0; i < 5; ++i) joints[static_cast<std::size_t>(i)].parent = i - 1;
  joints[2].translation = {0.5, 0, 0};
  const test::Quat a = test::axis_angle({0, 0, 1}, bend_degrees * kDegree);
  const test::Quat b = test::axis_angle({0, 1, 0}, sideways_degrees * kDegree);
  joints[2].rotation = {a[3] * b[0] - a[2] * b[1], a[3] * b[1], a[2] * b[3], a[3] * b[3]};  // a, then b
  joints[3].translation = {0.4, 0, 0};
  joints[4].translation = {0.2, 0.1, 0};
  return Chain(joints);
}

std::vector<Affine> solved(Chain c, const TwoBone& goal) {
  c.skeleton = c.test.view();
  EXPECT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
  return c.scene;
}

// The largest difference of a number of a matrix: of places in metres, of axes (unit vectors) by half as much.
double moved_by(const std::vector<Affine>& a, const std::vector<Affine>& b) {
  double most = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c)
        most = std::fmax(most, std::fabs(static_cast<double>(a[j].rows[r][c]) - static_cast<double>(b[j].rows[r][c])));
  return most;
}

// The largest movement in one of `steps` steps of a target on the way from `from` to `to`.
double largest_step(const Chain& c, TwoBone goal, const Vec3& from, const Vec3& to, int steps) {
  double most = 0;
  std::vector<Affine> last;
  for (int i = 0; i <= steps; ++i) {
    put(goal.target, plus(times(from, 1 - static_cast<double>(i) / steps), times(to, static_cast<double>(i) / steps)));
    std::vector<Affine> now = solved(c, goal);
    if (i > 0) most = std::fmax(most, moved_by(last, now));
    last = now;
  }
  return most;
}

constexpr int kSteps = 4000;

TEST(Steady, ThroughFullStretch) {
  TwoBone goal;
  goal.bend_axis[2] = 1;
  const double step = 0.3 / kSteps;
  int cases = 0;
  for (const double bend : {0.0, 1.0, 30.0, 90.0}) {
    for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{0, 0.8, 0.6}, Vec3{-0.6, 0.48, 0.64}}) {
      goal.soft = 0.97f;
      EXPECT_LT(largest_step(arm(bend), goal, times(way, 0.7), times(way, 1.0), kSteps), 12 * step) << bend;
      goal.soft = 1;  // the elbow comes in as the root of what is missing
      EXPECT_LT(largest_step(arm(bend), goal, times(way, 0.7), times(way, 1.0), kSteps), 3 * std::sqrt(step)) << bend;
      goal.soft = 0.97f;
      goal.max_stretch = 1.05f;
      EXPECT_LT(largest_step(arm(bend), goal, times(way, 0.7), times(way, 1.0), kSteps), 12 * step) << bend;
      goal.max_stretch = 1;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST(Steady, ThroughThePole) {
  test::Random random(11);
  TwoBone goal;
  int cases = 0, near = 0;
  for (int i = 0; i < 200; ++i) {
    const Chain c = arm(random.between(20, 120));
    const Vec3 pole = test::random_direction(random), path = normalised(cross(pole, test::random_direction(random)));
    put(goal.pole, pole);
    const Vec3 middle = times(pole, 0.6), side = times(path, 0.2);
    // The bend plane where the target is at the pole: carried along the shortest way. Where the path crosses the pole's
    // cone so that the plane must go over to its opposite, there is no answer without a jump.
    put(goal.target, middle);
    const std::vector<Affine> at = solved(c, goal);
    const Vec3 elbow = {at[2].rows[0][3], at[2].rows[1][3], at[2].rows[2][3]};
    const double opposite = std::fabs(dot(normalised(cross(elbow, pole)), normalised(cross(pole, path))));
    const double most = largest_step(c, goal, test::minus(middle, side), plus(middle, side), kSteps);
    if (opposite > 0.8) {
      ++near;
      continue;
    }
    EXPECT_LT(most, 150 * 0.4 / kSteps) << i << " " << opposite;
    ++cases;
  }
  EXPECT_EQ(cases + near, 200);
  EXPECT_GT(cases, 100);
}

TEST(Steady, ThroughTheOppositeOfThePose) {
  test::Random random(12);
  TwoBone goal;
  int cases = 0;
  for (int i = 0; i < 200; ++i) {
    const Chain c = arm(random.between(20, 120));
    const Vec3 end = {c.scene[3].rows[0][3], c.scene[3].rows[1][3], c.scene[3].rows[2][3]};
    const Vec3 behind = times(normalised(end), -0.6), path = normalised(cross(end, test::random_direction(random)));
    Vec3 pole = test::random_direction(random);
    if (length(cross(pole, normalised(end))) < 0.5) continue;
    put(goal.pole, pole);
    EXPECT_LT(largest_step(c, goal, test::minus(behind, times(path, 0.1)), plus(behind, times(path, 0.1)), kSteps),
              20 * 0.2 / kSteps)
        << i;
    ++cases;
  }
  EXPECT_GT(cases, 120);
}

// In the plane in which the pose is bent: without a pole the limb goes over its back, and meets its targets.
TEST(Steady, ThroughTheOppositeInThePlaneOfThePose) {
  const Chain c = arm(60);
  const Vec3 end = normalised(Vec3{c.scene[3].rows[0][3], c.scene[3].rows[1][3], 0});
  const Vec3 aside = cross({0, 0, 1}, end);
  TwoBone goal;
  const Vec3 from = plus(times(end, -0.6), times(aside, -0.1)), to = plus(times(end, -0.6), times(aside, 0.1));
  EXPECT_LT(largest_step(c, goal, from, to, kSteps), 4 * 0.2 / kSteps);
  put(goal.target, times(end, -0.6));
  const std::vector<Affine> there = solved(c, goal);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(there[3].rows[i][3], goal.target[i], 1e-6);
}

// And over the pole it swings round, where it could as well be the other way round at once.
TEST(Steady, OverThePoleInThePlaneOfThePose) {
  for (const double bend : {-60.0, 60.0}) {
    TwoBone goal;
    goal.pole[1] = 1;
    const double step = 0.3 / kSteps;
    EXPECT_LT(largest_step(arm(bend), goal, {-0.15, 0.6, 0}, {0.15, 0.6, 0}, kSteps), 100 * step) << bend;
  }
}

// The pose goes through straight, in its plane and past it, while the target stays.
TEST(Steady, PosesThroughStraight) {
  TwoBone goal;
  goal.bend_axis[2] = 1;
  put(goal.target, {0.5, 0.3, 0.2});
  int cases = 0;
  for (const double sideways : {0.0, 0.01, 1.0, 5.0}) {
    for (const Vec3& pole : {Vec3{0, 0, 0}, Vec3{0, 1, 0}}) {
      put(goal.pole, pole);
      std::vector<Affine> last;
      for (int i = -kSteps; i <= kSteps; ++i) {
        const std::vector<Affine> now = solved(arm(10.0 * i / kSteps, sideways), goal);
        if (i > -kSteps) {
          EXPECT_LT(moved_by(last, now), 60 * 10 * kDegree / kSteps) << sideways << " " << i;
        }
        last = now;
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 8);
}

std::vector<Affine> aimed(const Aim& goal) {
  Chain c = arm(40);
  bool reached = false;
  EXPECT_EQ(solve_aim(c.pose(), 2, goal, &reached), Status::ok);
  return c.scene;
}

double largest_step(Aim goal, const Vec3& from, const Vec3& to) {
  double most = 0;
  std::vector<Affine> last;
  for (int i = 0; i <= kSteps; ++i) {
    put(goal.target,
        plus(times(from, 1 - static_cast<double>(i) / kSteps), times(to, static_cast<double>(i) / kSteps)));
    std::vector<Affine> now = aimed(goal);
    if (i > 0) most = std::fmax(most, moved_by(last, now));
    last = now;
  }
  return most;
}

TEST(Steady, AimBehindPastThePoleAndNearerThanTheEye) {
  Aim goal;  // the joint is at 0.5, 0, 0, and looks along z
  put(goal.pole, {0, 1, 0});
  EXPECT_LT(largest_step(goal, {0.6, 0.1, -1}, {0.4, 0.1, -1}), 4 * 0.2 / kSteps);  // behind
  EXPECT_LT(largest_step(goal, {0.5, 0, -1}, {0.5, 0.2, -1}), 4 * 0.2 / kSteps);
  EXPECT_LT(largest_step(goal, {0.3, 1, 0.0}, {0.7, 1, 0.0}), 100 * 0.4 / kSteps);  // over the top, sideways
  put(goal.up, {1, 0, 0});
  put(goal.offset, {0, 0.2, 0});  // no ray goes through what is nearer than 0.2
  EXPECT_LT(largest_step(goal, {0.5, 0, 0.1}, {0.5, 0, 0.3}), 4 * std::sqrt(0.2 / kSteps));
}

// A thousand solves of all kinds: a difference on one processor only is a bug there.
TEST(Steady, SameBitsOnEveryProcessor) {
  test::Random random(13);
  std::uint64_t state = test::kHashStart;
  for (int i = 0; i < 1000; ++i) {
    std::vector<test::TestJoint> joints;
    for (int j = 0; j < 5; ++j) {
      const double s = random.between(0.5, 2);
      joints.push_back(test::random_joint(random, j - 1, {s, i % 7 == 0 ? -s : s, i % 5 == 0 ? 2 * s : s}));
    }
    if (i % 11 == 0) joints[2].rotation = {0, 0, 0, 1};
    if (i % 13 == 0) joints[3].translation = times(joints[2].translation, i % 2 == 0 ? 1 : -1);
    Chain c(joints);
    TwoBone goal;
    put(goal.target, test::random_vector(random, 3));
    if (i % 2 == 0) put(goal.pole, test::random_vector(random, 1));
    if (i % 3 == 0) put(goal.bend_axis, test::random_vector(random, 1));
    if (i % 4 == 0) goal.weight = 0.75f;
    if (i % 5 == 0) goal.soft = 0.9f;
    if (i % 6 == 0) goal.max_stretch = 1.5f;
    if (i % 7 == 0) goal.twist_rad = static_cast<float>(random.between(-9, 9));
    ASSERT_EQ(solve_two_bone(c.pose(), kLimb, goal), Status::ok);
    Aim look;
    put(look.target, test::random_vector(random, 3));
    if (i % 2 == 0) put(look.pole, test::random_vector(random, 1));
    if (i % 3 == 0) put(look.offset, test::random_vector(random, 1));
    if (i % 5 == 0) look.twist_rad = static_cast<float>(random.between(-9, 9));
    if (i % 7 == 0) look.weight = 0.5f;
    const std::uint32_t chain[] = {0, 2, 4};
    ASSERT_EQ(solve_look_at(c.pose(), {chain, 3}, look, 0.5f), Status::ok);
    ASSERT_EQ(solve_aim(c.pose(), 3, look), Status::ok);
    state = test::hash(state, c.scene.data(), c.scene.size() * sizeof c.scene[0]);
  }
  EXPECT_EQ(state, 0x3179F2EDE6FC1C4CULL);
}

}  // namespace
}  // namespace marrow
