// Joints that look at things, against directions in double precision.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "unit/ik/reach.h"

namespace marrow {
namespace {

using test::across;
using test::angle_deg;
using test::Chain;
using test::joint_of;
using test::length;
using test::Map;
using test::minus;
using test::plus;
using test::put;
using test::times;
using test::Vec3;

constexpr double kRadian = 3.14159265358979 / 180;

Chain random_neck(test::Random& random, bool mirrored, bool even) {
  Map above;
  for (int i = 0; i < 3; ++i) above.rows[i][i] = mirrored && i == 1 ? -0.5 : 0.5;
  std::vector<test::TestJoint> joints;
  for (int i = 0; i < 5; ++i) {
    const double scale = random.between(0.5, 2);
    joints.push_back(test::random_joint(random, i - 1, {scale, scale, scale}));
  }
  if (!even) joints[2].scale = {random.between(0.5, 2), -random.between(0.5, 2), random.between(0.5, 2)};
  return Chain(joints, above);
}

// Angle in radians between where the joint looks and where the target is, from the eye.
double aim_error(const Map& joint, const Aim& goal) {
  const Vec3 eye = point(joint, test::vec3(goal.offset));
  return kRadian * angle_deg(direction(joint, test::vec3(goal.forward)), minus(test::vec3(goal.target), eye));
}

// What is across the direction of the target: of the pole, and of where the joint's up is.
struct Sides {
  Vec3 pole, up;
};
Sides sides_of(const Map& joint, const Aim& goal) {
  const Vec3 to = test::normalised(minus(test::vec3(goal.target), test::origin_of(joint)));
  return {across(test::vec3(goal.pole), to), across(direction(joint, test::vec3(goal.up)), to)};
}
// Whether the pole has its whole say, and up is enough across to be measured.
bool has_sides(const Map& joint, const Aim& goal) {
  const Sides sides = sides_of(joint, goal);
  return length(sides.pole) >= 0.11 * length(test::vec3(goal.pole)) &&
         length(sides.up) >= 0.05 * length(direction(joint, test::vec3(goal.up)));
}
// Angle in radians between up and the pole's side.
double off_the_side(const Map& joint, const Aim& goal) {
  const Sides sides = sides_of(joint, goal);
  return kRadian * angle_deg(sides.pole, sides.up);
}

// What joints that look at targets show, at most, and how many there were.
struct Measured {
  int seen = 0, poled = 0;
  double off_target = 0, off_side = 0;  // radians
  void add(const Map& joint, const Aim& goal, bool has_pole) {
    const double error = aim_error(joint, goal);
    EXPECT_LT(error, 1e-4) << seen;
    off_target = std::fmax(off_target, error);
    ++seen;
    if (!has_pole || !has_sides(joint, goal)) return;
    const double off = off_the_side(joint, goal);
    EXPECT_LT(off, 1e-4) << seen;
    off_side = std::fmax(off_side, off);
    ++poled;
  }
  void print(const char* what) const {
    std::printf("%s %.2g rad, up %.2g rad; %d seen, %d with a pole\n", what, off_target, off_side, seen, poled);
  }
};

TEST(AimTest, LooksAtTheTargetWithUpOnThePolesSide) {
  test::Random random(2);
  int cases = 0;
  Measured measured;
  for (int i = 0; i < 100000; ++i) {
    Chain c = random_neck(random, i % 4 == 0, i % 8 != 3);
    const Map joint = c.maps()[2];
    const Vec3 at = test::origin_of(joint);
    Aim goal;
    put(goal.forward, times(test::random_direction(random), random.between(0.5, 2)));
    put(goal.up, times(test::random_direction(random), random.between(0.5, 2)));
    put(goal.target, plus(at, times(test::random_direction(random), random.between(0.05, 3))));
    if (i % 3 != 0) put(goal.offset, test::random_vector(random, 0.3));
    if (i % 2 == 0) put(goal.pole, times(test::random_direction(random), random.between(0.1, 10)));
    bool reached = false;
    ASSERT_EQ(solve_aim(c.pose(), 2, goal, &reached), Status::ok);
    ++cases;
    if (!reached) continue;
    const Map now = c.maps()[2];
    const Vec3 eye = point(now, test::vec3(goal.offset)), way = minus(test::vec3(goal.target), at);
    if (length(minus(test::vec3(goal.target), eye)) < 0.02 * length(way)) continue;  // nothing to measure an angle by
    EXPECT_LT(length(minus(test::origin_of(now), at)), 1e-5);
    measured.add(now, goal, i % 2 == 0);
  }
  EXPECT_EQ(cases, 100000);
  EXPECT_GT(measured.seen, 80000);
  EXPECT_GT(measured.poled, 35000);
  measured.print("aim");
}

TEST(LookAt, TheLastOfAChainSeesTheTargetWithUpOnThePolesSide) {
  test::Random random(3);
  Measured measured;
  for (int i = 0; i < 20000; ++i) {
    Chain c = random_neck(random, i % 4 == 0, true);
    const std::uint32_t joints[] = {1, 2, 4};
    Aim goal;
    put(goal.target, plus(test::origin_of(c.maps()[4]), times(test::random_direction(random), random.between(4, 8))));
    put(goal.offset, test::random_vector(random, 0.1));
    if (i % 2 == 0) put(goal.pole, test::random_direction(random));
    bool reached = false;
    ASSERT_EQ(solve_look_at(c.pose(), {joints, 3}, goal, static_cast<float>(random.between(0, 1)), &reached),
              Status::ok);
    if (!reached) continue;
    const Map now = c.maps()[4];
    measured.add(now, goal, i % 2 == 0);
  }
  EXPECT_GT(measured.seen, 19000);
  EXPECT_GT(measured.poled, 9000);
  measured.print("look at");
}

TEST(AimTest, NothingDegenerateBecomesInfinite) {
  const Vec3 directions[] = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1e-12, 0}, {1, 1e-6, 0}, {0, 0, 2}};
  const Vec3 scales[] = {{1, 1, 1}, {0, 0, 0}, {1, 0, 2}, {-1, 1, 3}};
  int cases = 0;
  for (const Vec3& scale : scales) {
    for (const Vec3& target : directions) {
      for (const Vec3& pole : directions) {
        for (const Vec3& forward : directions) {
          for (const Vec3& up : directions) {
            for (const Vec3& offset : directions) {
              std::vector<test::TestJoint> joints(2);
              joints[1].parent = 0;
              joints[1].scale = scale;
              Chain c(joints);
              Aim goal;
              put(goal.target, target);
              put(goal.pole, pole);
              put(goal.forward, forward);
              put(goal.up, up);
              put(goal.offset, offset);
              goal.twist_rad = cases % 3 == 0 ? 1.0f : 0.0f;
              AimTurn out;
              ASSERT_EQ(aim(c.scene[1], goal, out), Status::ok) << cases;
              double squared = 0;
              for (const float x : out.turn) squared += static_cast<double>(x) * static_cast<double>(x);
              EXPECT_NEAR(squared, 1, 1e-5) << cases;
              ++cases;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 4 * 6 * 6 * 6 * 6 * 6);
}

TEST(AimTest, OppositeTargetsAreReached) {
  int cases = 0;
  for (const Vec3& forward : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.6, 0, -0.8}}) {
    for (const Vec3& pole : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
      std::vector<test::TestJoint> joints(1);
      Chain c(joints);
      Aim goal;
      put(goal.forward, forward);
      put(goal.target, times(forward, -2));
      put(goal.pole, pole);
      bool reached = false;
      ASSERT_EQ(solve_aim(c.pose(), 0, goal, &reached), Status::ok);
      EXPECT_TRUE(reached);
      EXPECT_LT(aim_error(c.maps()[0], goal), 1e-6);
      // Without a pole over the back, about what is across forward and up.
      if (length(pole) == 0) {
        EXPECT_NEAR(c.maps()[0].rows[1][1], -1, 1e-6);
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 9);
}

TEST(AimTest, SaysWhatCannotBeSeen) {
  std::vector<test::TestJoint> joints(1);
  Aim goal;  // looks along z
  put(goal.offset, {0, 0.5, 0.25});
  int cases = 0;
  // The ray never comes nearer than 0.5, and begins at √0.3125 = 0.559.
  for (const double distance : {0.0, 0.4, 0.49, 0.55, 0.57, 3.0}) {
    Chain c(joints);
    put(goal.target, {distance, 0, 0});
    bool reached = distance < 0.5;
    ASSERT_EQ(solve_aim(c.pose(), 0, goal, &reached), Status::ok);
    EXPECT_EQ(reached, distance > 0.559) << distance;
    ++cases;
  }
  EXPECT_EQ(cases, 6);
}

TEST(LookAt, FalloffSharesTheTurn) {
  std::vector<test::TestJoint> joints(3);
  joints[1].parent = 0;
  joints[2].parent = 1;
  const std::uint32_t chain[] = {0, 1, 2};
  Aim goal;  // far to the side, so that all turns are about y and their sum is a right angle
  put(goal.target, {1e6, 0, 0});
  const double want[][3] = {{0, 0, 90}, {90.0 / 7, 180.0 / 7, 360.0 / 7}, {30, 30, 30}};
  const float falloffs[] = {0, 0.5f, 1};
  int cases = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Chain c(joints);
    ASSERT_EQ(solve_look_at(c.pose(), {chain, 3}, goal, falloffs[i]), Status::ok);
    for (std::size_t j = 0; j < 3; ++j) {
      const test::Quat q = joint_of(c.local.data(), j).rotation;
      // Shares are taken on the chord, not on the arc: a little less or more than these.
      EXPECT_NEAR(2 * std::atan2(q[1], q[3]) / kRadian, want[i][j], 1.5) << i << " " << j;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 9);
}

TEST(LookAt, BadCallsAreRefusedAndWriteNothing) {
  test::Random random(9);
  Chain c = random_neck(random, false, true);
  const std::vector<SoaTransform> local = c.local;
  Aim good;
  put(good.target, {1, 2, 3});
  int cases = 0;
  const auto refused = [&](const Aim& goal, const std::vector<std::uint32_t>& joints, float falloff) {
    bool reached = true;
    EXPECT_EQ(solve_look_at(c.pose(), joints, goal, falloff, &reached), Status::bad_argument) << cases;
    EXPECT_TRUE(reached);
    EXPECT_EQ(std::memcmp(local.data(), c.local.data(), local.size() * sizeof local[0]), 0);
    ++cases;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const std::vector<std::uint32_t> joints = {1, 2, 4};
  for (const float bad : {nan, infinite, -infinite}) {
    for (int i = 0; i < 3; ++i) {
      for (float(Aim::*const member)[3] : {&Aim::target, &Aim::pole, &Aim::forward, &Aim::up, &Aim::offset}) {
        Aim goal = good;
        put(goal.pole, {0, 1, 0});
        (goal.*member)[i] = bad;
        refused(goal, joints, 1);
        AimTurn out;
        EXPECT_EQ(aim(c.scene[2], goal, out), Status::bad_argument) << cases;
      }
    }
    Aim goal = good;
    goal.twist_rad = bad;
    refused(goal, joints, 1);
    refused(good, joints, bad);
    goal = good;
    goal.weight = bad;
    refused(goal, joints, 1);
  }
  for (const std::vector<std::uint32_t>& wrong :
       {std::vector<std::uint32_t>{}, {2, 1}, {1, 1}, {1, 5}, {~0u}, {~0u, 1}, {1, ~0u, 2}})
    refused(good, wrong, 1);
  refused(good, joints, -0.1f);
  EXPECT_EQ(cases, 45 + 9 + 7 + 1);
  EXPECT_EQ(solve_aim({c.skeleton, {c.local.data(), c.local.size() - 1}, c.scene}, 1, good), Status::bad_argument);
  EXPECT_EQ(solve_aim({c.skeleton, c.local, {c.scene.data(), c.scene.size() - 1}}, 1, good), Status::bad_argument);
}

TEST(LookAt, WeightZeroChangesNoBit) {
  test::Random random(10);
  for (int i = 0; i < 100; ++i) {
    Chain c = random_neck(random, false, true);
    const std::vector<SoaTransform> local = c.local;
    const std::vector<Affine> scene = c.scene;
    Aim goal;
    put(goal.target, test::random_vector(random, 2));
    goal.weight = 0;
    const std::uint32_t joints[] = {1, 2, 4};
    ASSERT_EQ(solve_look_at(c.pose(), {joints, 3}, goal, 0.5f), Status::ok);
    EXPECT_EQ(std::memcmp(local.data(), c.local.data(), local.size() * sizeof local[0]), 0);
    EXPECT_EQ(std::memcmp(scene.data(), c.scene.data(), scene.size() * sizeof scene[0]), 0);
  }
}

}  // namespace
}  // namespace marrow
