// Feet on the ground: heights, slopes, planting and release.
#include "unit/ik/feet_support.h"

namespace marrow {
namespace {

using test::Map;
using test::Quat;
using test::same;
using test::Vec3;
using test::Walker;

constexpr double kRate = 5.834 / 0.25;  // of the default ease_s

double distance(const Vec3& a, const Vec3& b) {
  return test::length(test::minus(a, b));
}

TEST(Feet, LevelGroundChangesNothing) {
  for (const bool hit : {false, true}) {
    Walker w;
    w.stand({1, 2, 3}, 0.7);
    for (int i = 0; i < 30; ++i) {
      w.pose(0.01 * i);
      if (hit) w.floor(0, 2), w.floor(1, 2);
      const std::vector<Affine> animated = w.scene;
      ASSERT_EQ(w.step(1.0f / 60), Status::ok);
      for (std::size_t j = 0; j < animated.size(); ++j) {
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 4; ++c) EXPECT_NEAR(w.scene[j].rows[r][c], animated[j].rows[r][c], 5e-6f) << j;
        }
      }
    }
  }
}

TEST(Feet, SolesGoToTheirGroundAndThePelvisWithTheLowest) {
  int cases = 0;
  for (const double left : {-0.2, 0.0, 0.15}) {
    for (const double right : {-0.1, 0.0, 0.25}) {
      Walker w;
      const Vec3 a = w.sole(0), b = w.sole(1), p = w.pelvis();
      w.floor(0, left);
      w.floor(1, right);
      w.settle();
      EXPECT_LT(distance(w.sole(0), test::Vec3{a[0], left, a[2]}), 2e-5);
      EXPECT_LT(distance(w.sole(1), test::Vec3{b[0], right, b[2]}), 2e-5);
      EXPECT_NEAR(w.pelvis()[1] - p[1], std::min(left, right), 2e-5);
      // Ankles keep their attitude.
      for (const std::size_t j : {std::size_t{7}, std::size_t{8}}) {
        EXPECT_LT(test::angle_deg(test::direction(w.world(j), {0, 0, 1}), {0, 0, 1}), 0.01);
        EXPECT_LT(test::angle_deg(test::direction(w.world(j), {0, 1, 0}), {0, 1, 0}), 0.01);
      }
      EXPECT_TRUE(w.motion[0].reached && w.motion[1].reached);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 9);
}

TEST(Feet, LeanWithTheSlopeUpToALimit) {
  int cases = 0;
  for (const double slope : {0.1, 0.3, 0.6, 0.9}) {
    for (const double towards : {0.0, 1.0, 2.5, 4.0}) {
      Walker w;
      w.feet.slope_rad = 0.5f;
      const Vec3 normal{std::sin(slope) * std::cos(towards), std::cos(slope), std::sin(slope) * std::sin(towards)};
      const Vec3 a = w.sole(0);
      w.floor(0, 0.1, normal);
      w.settle();
      EXPECT_LT(distance(w.sole(0), {a[0], 0.1, a[2]}), 2e-5) << "turned about its sole";
      const Vec3 up = test::direction(w.world(7), {0, 1, 0});
      EXPECT_NEAR(test::angle_deg(up, {0, 1, 0}), std::min(slope, 0.5) * 180 / M_PI, 0.02);
      EXPECT_NEAR(test::angle_deg(up, normal), std::max(0.0, slope - 0.5) * 180 / M_PI, 0.02);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 16);
  Walker w;  // a wall is no ground
  const Vec3 a = w.sole(0);
  w.floor(0, 0.3, {1, 0.1, 0});
  w.settle();
  EXPECT_LT(distance(w.sole(0), a), 1e-5);
}

// The character walks and turns over a planted foot.
TEST(Feet, PlantedStaysWhereItWas) {
  Walker w;
  int cases = 0;
  Vec3 at{}, heading{};
  for (int i = 0; i < 40; ++i) {
    w.stand({0.002 * i, 0, 0.004 * i}, 0.01 * i);
    w.pose();
    w.ground[0].planted = i >= 10;
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
    if (i == 10) {
      at = w.sole(0);
      heading = test::direction(w.world(7), {0, 0, 1});
    }
    if (i < 10) continue;
    EXPECT_LT(distance(w.sole(0), at), 2e-5) << i;
    EXPECT_LT(test::angle_deg(test::direction(w.world(7), {0, 0, 1}), heading), 0.02) << i;
    EXPECT_TRUE(w.motion[0].reached);
    ++cases;
  }
  EXPECT_EQ(cases, 30);
  EXPECT_GT(distance(w.sole(1), at), 0.1);
}

// Released, the sole goes to its target as the closed form says, at any frame rate, from the speed that it had: none.
TEST(Feet, ReleaseEasesOutTheSameAtAnyFrameRate) {
  int cases = 0;
  for (const int hz : {15, 30, 60, 120, 240}) {
    Walker w;
    const double speed = 0.2, released = 0.4;
    double before = 0;
    for (int i = 0; i <= hz; ++i) {
      const double t = static_cast<double>(i) / hz;
      w.stand({0, 0, speed * t});
      w.pose();
      const Vec3 target = w.sole(0);
      w.ground[0].planted = t <= released + 1e-6;
      ASSERT_EQ(w.step(i == 0 ? 0.0f : 1.0f / static_cast<float>(hz)), Status::ok);
      const double offset = w.sole(0)[2] - target[2];
      const double late = t - released;
      if (late > 1e-6) {
        const double x = -speed * released, v = -speed;
        const double want = (x + (v + kRate * x) * late) * std::exp(-kRate * late);
        EXPECT_NEAR(offset, want, 1e-5) << hz << " Hz at " << t;
        ++cases;
      } else {
        EXPECT_NEAR(offset, -speed * t, 1e-5);
      }
      EXPECT_LT(std::fabs(offset - before), 1.0 / hz) << "no jump";
      before = offset;
    }
    EXPECT_LT(std::fabs(before), 1e-3) << "over";
  }
  EXPECT_EQ(cases, 9 + 18 + 36 + 72 + 144);
}

TEST(Feet, AStepInTheGroundIsEased) {
  int cases = 0;
  for (const int hz : {15, 30, 60, 240}) {
    Walker w;
    w.floor(0, 0);
    for (int i = 0; i <= hz; ++i) {
      const double late = static_cast<double>(i) / hz - 0.2;
      w.pose();
      w.floor(0, late > -1e-6 ? 0.2 : 0.0);
      ASSERT_EQ(w.step(1.0f / static_cast<float>(hz)), Status::ok);
      // The frame in which the step is seen has a frame's time of it.
      const double t = late > -1e-6 ? late + 1.0 / hz : 0;
      const double want = late > -1e-6 ? 0.2 - 0.2 * (1 + kRate * t) * std::exp(-kRate * t) : 0;
      EXPECT_NEAR(w.sole(0)[1], want, 2e-5) << hz << " Hz at " << late;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 16 + 31 + 61 + 241);
}

// On a plane that stays, a moving character's soles are on it without delay.
TEST(Feet, ASlopeIsFollowedWithoutDelay) {
  Walker w;
  int cases = 0;
  for (int i = 0; i < 120; ++i) {
    w.stand({0, 0, 0.02 * i});
    w.pose();
    for (std::size_t side = 0; side < 2; ++side) {
      const double z = w.sole(side)[2];
      w.floor(side, 0.2 * z, {0, 1, -0.2});
    }
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
    for (std::size_t side = 0; side < 2; ++side, ++cases)
      EXPECT_NEAR(w.sole(side)[1], 0.2 * w.sole(side)[2], 3e-5) << i;
  }
  EXPECT_EQ(cases, 240);
}

TEST(Feet, ThePelvisGivesWayToAPlantedFootThatIsFar) {
  Walker w;
  const Vec3 p = w.pelvis();
  Vec3 at{};
  double low = 0;
  for (int i = 0; i < 60; ++i) {
    w.stand({0, 0, 0.006 * i});
    w.pose();
    w.ground[0].planted = true;
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
    if (i == 0) at = w.sole(0);
    EXPECT_LT(distance(w.sole(0), at), 3e-5) << i;
    EXPECT_TRUE(w.motion[0].reached) << i;
    const double now = w.pelvis()[1] - p[1];
    EXPECT_LT(std::fabs(now - low), 0.01) << "without a jump";
    low = now;
  }
  EXPECT_LT(low, -0.02);
  for (int i = 0; i < 60; ++i) {  // too far for any pelvis: still finite, and told
    w.stand({0, 0, 0.36 + 0.05 * i});
    w.pose();
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
  }
  EXPECT_FALSE(w.motion[0].reached);
  EXPECT_GE(w.pelvis()[1] - p[1], -0.5 - 1e-5);
}

TEST(Feet, TeleportedTheyBeginAnew) {
  Walker w;
  w.ground[0].planted = true;
  ASSERT_EQ(w.step(1.0f / 60), Status::ok);
  w.stand({10, 0, 0});
  w.pose();
  const Vec3 target = w.sole(0);
  w.frame.teleported = true;
  ASSERT_EQ(w.step(1.0f / 60), Status::ok);
  EXPECT_LT(distance(w.sole(0), target), 1e-5);
}

TEST(Feet, WeightZeroLeavesEveryBit) {
  int cases = 0;
  for (const int which : {0, 1, 2}) {
    Walker w;
    w.floor(0, 0.1);
    w.floor(1, -0.1);
    w.settle();
    w.pose();
    const std::vector<SoaTransform> local = w.local;
    const std::vector<Affine> scene = w.scene;
    if (which == 0) w.frame.weight = 0;
    if (which >= 1) w.legs[0].weight = w.legs[1].weight = 0;
    if (which == 2) w.legs[1].weight = 1;
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
    EXPECT_EQ(same(local, w.local), which < 2);
    EXPECT_EQ(same(scene, w.scene), which < 2);
    if (which == 2) {
      EXPECT_TRUE(test::same_bits(local, w.local, 2));
      EXPECT_TRUE(test::same_bits(local, w.local, 5));
      EXPECT_TRUE(test::same_bits(local, w.local, 7));
      EXPECT_FALSE(test::same_bits(local, w.local, 3));
    }
    w.frame.weight = 1;
    w.legs[0].weight = 1;
    w.pose();
    ASSERT_EQ(w.step(1.0f / 60), Status::ok);
    EXPECT_NEAR(w.sole(0)[1], 0.1, 2e-5) << "the motion went on";
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

// Whatever stands above the root and wherever the character stands: the same soles.
TEST(Feet, ScaledAndMirroredCharactersStandToo) {
  int cases = 0;
  for (const Vec3& scale : {Vec3{1, 1, 1}, Vec3{0.01, 0.01, 0.01}, Vec3{-1, 1, 1}}) {
    Walker w(test::from_trs({0, 0, 0}, {0, 0, 0, 1}, scale));
    const double size = scale[1];
    w.frame.world_from_model = test::to_affine(test::from_trs({3, 1, 2}, test::axis_angle({0, 1, 0}, 1), {2, 2, 2}));
    w.feet.lower_m = 10;
    const Vec3 a = w.sole(0);
    const Vec3 normal{0.2, 1, -0.1};
    w.floor(0, 1 + 0.2 * size, normal);
    w.settle();
    EXPECT_LT(distance(w.sole(0), {a[0], 1 + 0.2 * size, a[2]}), 1e-4 * size) << scale[0];
    EXPECT_LT(test::angle_deg(test::direction(w.world(7), {0, 1, 0}), normal), 0.05) << scale[0];
    std::vector<Affine> scene(w.scene.size());
    ASSERT_EQ(local_to_model(w.skeleton, w.local, scene), Status::ok);
    EXPECT_TRUE(same(scene, w.scene));
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

}  // namespace
}  // namespace marrow
