// Feet on the ground: heights, slopes, planting and release, and what a bad call does.
#include "marrow/feet.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "marrow/local_to_model.h"
#include "support/allocations.h"
#include "support/pose_file.h"
#include "support/poses.h"

namespace marrow {
namespace {

using test::Map;
using test::Quat;
using test::Vec3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();
constexpr double kRate = 5.834 / 0.25;  // of the default ease_s

double distance(const Vec3& a, const Vec3& b) {
  return test::length(test::minus(a, b));
}
Vec3 vec(const float (&v)[3]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// Two legs of 0.45 + 0.45 m, knees bent forward (z) by 0.3 rad each way, ankles 0.1 m above the soles; joints 0 a root,
// 1 the pelvis, 2 and 3 hips, 4 and 5 knees, 6 and 7 ankles, 8 and 9 toes, 10 the head.
class Walker {
 public:
  explicit Walker(const Map& above = {}) {
    const Quat bend = test::axis_angle({1, 0, 0}, -0.3), back = test::axis_angle({1, 0, 0}, 0.6);
    const double hip = 0.1 + 0.9 * std::cos(0.3);
    std::vector<test::TestJoint> joints = {{-1, {0, 0, 0}},          {0, {0, hip, 0}},         {1, {0.1, 0, 0}, bend},
                                           {1, {-0.1, 0, 0}, bend},  {2, {0, -0.45, 0}, back}, {3, {0, -0.45, 0}, back},
                                           {4, {0, -0.45, 0}, bend}, {5, {0, -0.45, 0}, bend}, {6, {0, -0.05, 0.1}},
                                           {7, {0, -0.05, 0.1}},     {1, {0, 0.6, 0}}};
    // Breadth-first: the head comes with the hips.
    std::vector<test::TestJoint> sorted(joints.begin(), joints.begin() + 4);
    sorted.push_back(joints[10]);
    for (std::size_t j = 4; j < 10; ++j) {
      sorted.push_back(joints[j]);
      if (sorted.back().parent >= 4) ++sorted.back().parent;
    }
    rest_ = std::make_unique<test::TestSkeleton>(sorted, std::vector<Map>{above});
    skeleton = rest_->view();
    local.resize(skeleton.soa_size());
    scene.resize(skeleton.joint_count);
    for (std::uint32_t side = 0; side < 2; ++side) {
      legs[side].hip = 2 + side;
      legs[side].knee = 5 + side;
      legs[side].ankle = 7 + side;
      legs[side].sole[1] = -0.1f;
      legs[side].sole[2] = 0.05f;
    }
    feet.feet = legs;
    feet.pelvis = 1;

    pose();
  }
  // The animated pose; `swing` lifts the left ankle and puts it forward.
  void pose(double swing_rad = 0) {
    local = rest_->rest;
    if (swing_rad != 0) {
      const Quat q = test::axis_angle({1, 0, 0}, -0.3 - swing_rad);
      for (std::size_t i = 0; i < 4; ++i) local[0].rotation[i][2] = static_cast<float>(q[i]);
    }
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  void stand(const Vec3& at, double turn_rad = 0) {
    frame.world_from_scene = test::to_affine(test::from_trs(at, test::axis_angle({0, 1, 0}, turn_rad), {1, 1, 1}));
  }
  Status step(float dt_s) {
    frame.dt_s = dt_s;
    return place_feet(skeleton, feet, frame, ground, motion, local, scene);
  }
  // For so long that all has eased, standing still.
  void settle() {
    for (int i = 0; i < 200; ++i) {
      pose();
      ASSERT_EQ(step(1.0f / 60), Status::ok);
    }
  }
  void floor(std::size_t side, double height, const Vec3& normal = {0, 1, 0}) {
    ground[side].hit = true;
    float sole[3];
    EXPECT_EQ(foot_sole(legs[side], frame.world_from_scene, scene, sole), Status::ok);
    for (int i = 0; i < 3; ++i) {
      ground[side].point[i] = i == 1 ? static_cast<float>(height) : sole[i];
      ground[side].normal[i] = static_cast<float>(normal[static_cast<std::size_t>(i)]);
    }
  }
  Map world(std::size_t joint) const { return test::to_map(frame.world_from_scene) * test::to_map(scene[joint]); }
  Vec3 sole(std::size_t side) const { return test::point(world(legs[side].ankle), vec(legs[side].sole)); }
  Vec3 pelvis() const { return test::point(world(1), {0, 0, 0}); }

  Skeleton skeleton;
  std::array<Foot, 2> legs;
  Feet feet;
  FeetFrame frame;
  std::array<FootGround, 2> ground;
  std::array<FootMotion, 2> motion{};
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;

 private:
  std::unique_ptr<test::TestSkeleton> rest_;
};

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
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
      EXPECT_TRUE(w.motion[0].reached != 0 && w.motion[1].reached != 0);
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
    EXPECT_TRUE(w.motion[0].reached != 0);
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
    EXPECT_TRUE(w.motion[0].reached != 0) << i;
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
  EXPECT_EQ(w.motion[0].reached, 0);
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
    w.frame.world_from_scene = test::to_affine(test::from_trs({3, 1, 2}, test::axis_angle({0, 1, 0}, 1), {2, 2, 2}));
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

TEST(Feet, StayFiniteOnAnything) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    test::Poses p(seed, 40, 2);
    test::Random random(seed);
    Foot foot;
    std::uint32_t line[64] = {39}, count = 1;
    while (line[count - 1] >= p.skeleton.root_count) line[count] = p.skeleton.parents[line[count - 1]], ++count;
    if (count < 3) continue;
    foot.ankle = line[0], foot.knee = line[1], foot.hip = line[count - 1];
    foot.sole[1] = -0.5f;
    Feet feet;
    feet.feet = {&foot, 1};
    feet.pelvis = seed % 2 == 0 ? foot.hip : kNoJoint;
    FootGround ground;
    FootMotion motion = {};
    FeetFrame frame;
    std::vector<Affine> scene(40);
    for (int i = 0; i < 30; ++i, ++cases) {
      p.out = p.pose[static_cast<std::size_t>(i / 4 % 2)];
      if (seed % 5 == 0) p.out[0].scale[1][0] = 0;
      ASSERT_EQ(local_to_model(p.skeleton, p.out, scene), Status::ok);
      ground.hit = random.below(3) > 0;
      ground.planted = random.below(3) > 0;
      for (int k = 0; k < 3; ++k) {
        ground.point[k] = static_cast<float>(random.between(-5, 5));
        ground.normal[k] = random.below(4) == 0 ? 0.0f : static_cast<float>(random.between(-1, 1));
      }
      frame.dt_s = static_cast<float>(random.between(0, 0.3));
      ASSERT_EQ(place_feet(p.skeleton, feet, frame, {&ground, 1}, {&motion, 1}, p.out, scene), Status::ok) << seed;
      for (std::size_t j = 0; j < 40; ++j) {
        const test::TestJoint t = test::joint_of(p.out.data(), j);
        double squared = 0;
        for (const double x : t.rotation) squared += x * x;
        ASSERT_NEAR(squared, 1, 1e-5) << seed;
        ASSERT_TRUE(std::isfinite(scene[j].rows[0][3] + scene[j].rows[2][1]));
      }
    }
  }
  EXPECT_GT(cases, 1500);
}

TEST(Feet, BadCallsWriteNothing) {
  Walker w;
  w.settle();
  w.pose();
  const std::vector<SoaTransform> local = w.local;
  const std::vector<Affine> scene = w.scene;
  const std::array<FootMotion, 2> motion = w.motion;
  int refused = 0;
  const auto refuses = [&](auto change) {
    const Feet feet = w.feet;
    const FeetFrame frame = w.frame;
    const Foot leg = w.legs[1];
    const FootGround ground = w.ground[1];
    change();
    EXPECT_EQ(place_feet(w.skeleton, w.feet, w.frame, w.ground, w.motion, w.local, w.scene), Status::bad_argument)
        << refused;
    EXPECT_EQ(std::memcmp(motion.data(), w.motion.data(), sizeof motion), 0) << refused;
    EXPECT_TRUE(same(local, w.local));
    w.feet = feet;
    w.frame = frame;
    w.legs[1] = leg;
    w.ground[1] = ground;
    w.scene = scene;
    ++refused;
  };
  for (const float bad : {kNan, kInfinite, -kInfinite, -1.0f}) {
    refuses([&] { w.frame.dt_s = bad; });
    refuses([&] { w.frame.weight = bad; });
    refuses([&] { w.feet.lower_m = bad; });
    refuses([&] { w.feet.reach = bad; });
    refuses([&] { w.feet.slope_rad = bad; });
    refuses([&] { w.feet.ease_s = bad; });
    refuses([&] { w.legs[1].weight = bad; });
    refuses([&] { w.frame.world_from_scene.rows[0][0] = bad; });  // -1: mirrored
    if (bad == -1.0f) continue;
    refuses([&] { w.frame.up[2] = bad; });
    refuses([&] { w.legs[1].sole[0] = bad; });
    refuses([&] { w.legs[1].bend_axis[0] = bad; });
    refuses([&] { w.ground[1].point[0] = bad; });
    refuses([&] { w.ground[1].normal[0] = bad; });
    refuses([&] { w.scene[8].rows[0][3] = bad; });
    refuses([&] { w.scene[3].rows[1][1] = bad; });
    refuses([&] { w.scene[1].rows[1][3] = bad; });
  }
  refuses([&] { w.frame.up[1] = 2; });
  refuses([&] { w.feet.ease_s = 0; });
  refuses([&] { w.legs[1].ankle = 11; });
  refuses([&] { w.legs[1].knee = 5; });
  refuses([&] { w.legs[1].hip = w.legs[1].knee; });
  refuses([&] { w.feet.pelvis = 2; });
  refuses([&] { w.feet.pelvis = 11; });
  // Of the skeleton's 11 joints none is called so; a look at its parent would be far outside.
  for (const std::uint32_t far : {11u, 100u, 0xF0000000u, 0xFFFFFFFFu}) {
    refuses([&] { w.legs[1].hip = far; });
    refuses([&] { w.legs[1].knee = far; });
    refuses([&] { w.legs[1].ankle = far; });
    refuses([&] { w.legs[1] = {.hip = far, .knee = far, .ankle = far}; });
    refuses([&] { w.feet.pelvis = far; });
  }
  EXPECT_EQ(refused, 4 * 8 + 3 * 8 + 7 + 4 * 5);
  EXPECT_EQ(place_feet(w.skeleton, w.feet, w.frame, {w.ground.data(), 1}, w.motion, w.local, w.scene),
            Status::bad_argument);
  EXPECT_EQ(place_feet(w.skeleton, w.feet, w.frame, w.ground, {w.motion.data(), 1}, w.local, w.scene),
            Status::bad_argument);
  EXPECT_EQ(place_feet(w.skeleton, w.feet, w.frame, w.ground, w.motion, {w.local.data(), 1}, w.scene),
            Status::bad_argument);
  EXPECT_EQ(place_feet(w.skeleton, w.feet, w.frame, w.ground, w.motion, w.local, {w.scene.data(), 10}),
            Status::bad_argument);
  float sole[3];
  EXPECT_EQ(foot_sole(w.legs[0], w.frame.world_from_scene, {w.scene.data(), 7}, sole), Status::bad_argument);
}

TEST(Feet, AllocateNothing) {
  Walker w;
  w.floor(0, 0.1);
  int failures = 0;
  const std::size_t before = test::allocation_count();
  for (int i = 0; i < 1000; ++i) {
    w.ground[0].planted = i % 30 < 15;
    w.frame.dt_s = 1.0f / 60;
    failures += place_feet(w.skeleton, w.feet, w.frame, w.ground, w.motion, w.local, w.scene) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

// The same bits on every processor, with SIMD or without.
TEST(Feet, SameBitsEverywhere) {
  Walker w;
  test::Random random(78);
  std::uint64_t state = test::kHashStart;
  for (int i = 0; i < 200; ++i) {
    w.frame.world_from_scene.rows[2][3] = static_cast<float>(random.between(0, 0.0625)) + 0.01f * static_cast<float>(i);
    w.pose();
    for (FootGround& g : w.ground) {
      g.hit = true;
      g.planted = random.below(10) < 7;
      g.point[1] = i / 20 % 2 == 0 ? 0.0f : 0.125f;
      g.normal[0] = static_cast<float>(random.between(-0.5, 0.5));
    }
    ASSERT_EQ(w.step(static_cast<float>(random.between(0, 0.04))), Status::ok);
    state = test::hash(state, w.local.data(), w.local.size() * sizeof(SoaTransform));
    state = test::hash(state, w.scene.data(), w.scene.size() * sizeof(Affine));
  }
  EXPECT_EQ(state, 0xe2a77774ad5d8435u) << std::hex << state;
}

}  // namespace
}  // namespace marrow
