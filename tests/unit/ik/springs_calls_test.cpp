// Spring bones at their edges: jumps, weights, odd frames and bad calls.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "springs/spring_state.h"
#include "support/allocations.h"
#include "support/bad_numbers.h"
#include "support/pose_file.h"
#include "support/poses.h"
#include "unit/ik/springs_support.h"

namespace marrow {
namespace {

using test::distance;
using test::kInfinity;
using test::kNan;
using test::Rod;
using test::soft;
using test::Vec3;

// Some frames of a rod that is carried along a curve.
void shake(Rod& rod, int frames, double from_s = 0) {
  for (int i = 0; i < frames; ++i) {
    const double t = from_s + i / 60.0;
    rod.pose({0.1 * std::sin(9 * t), 0.1 * std::cos(7 * t), 0}, test::axis_angle({0.3, 1, 0.2}, std::sin(4 * t)));
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
  }
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// A jump of 100 m with half a turn: every bone stands to its animated direction as it did.
TEST(Springs, AJumpMovesThemAlong) {
  int cases = 0;
  for (const bool told : {false, true}) {
    Rod rod(4, soft(), 0.1), still(4, soft(), 0.1);
    shake(rod, 60);
    shake(still, 60);
    rod.frame.gravity[1] = still.frame.gravity[1] = 0;
    const test::Quat turn = test::axis_angle({0, 1, 0}, M_PI);
    const Vec3 far = told ? Vec3{0.5, 0, 0} : Vec3{100, 0, 0};
    const test::Quat was = test::axis_angle({0.3, 1, 0.2}, std::sin(4 * 59 / 60.0));
    const Vec3 place{0.1 * std::sin(9 * 59 / 60.0), 0.1 * std::cos(7 * 59 / 60.0), 0};
    const Affine turned = test::to_affine(test::from_trs(far, turn, {1, 1, 1}));
    rod.frame.world_from_model = turned;
    rod.frame.teleported = told;
    for (int i = 0; i < 30; ++i) {
      rod.pose(place, was);
      still.pose(place, was);
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      rod.frame.teleported = false;
      still.frame.teleported = i == 0;  // along no way, so that it comes to a stop from the same speed
      ASSERT_EQ(still.step(1.0f / 60), Status::ok);
      for (std::size_t b = 0; b < rod.bones(); ++b, ++cases)
        EXPECT_LT(distance(rod.direction(b), still.direction(b)), 1e-4) << told << ", bone " << b << " at " << i;
    }
  }
  EXPECT_EQ(cases, 2 * 30 * 4);
}

TEST(Springs, AJumpThatIsNotOneFlings) {
  Rod rod(1, soft()), jumping(1, soft());
  rod.frame.teleport_m = 10;
  for (int i = 0; i < 60; ++i) {
    for (Rod* r : {&rod, &jumping}) {
      r->pose({0, 0, i < 50 ? 0.0 : 2.0});
      ASSERT_EQ(r->step(1.0f / 60), Status::ok);
    }
  }
  EXPECT_LT(rod.direction(0)[2], -0.3) << "flung";
  EXPECT_NEAR(jumping.direction(0)[2], 0, 1e-6) << "moved along";
}

TEST(Springs, ResetBeginsAtRestInThePose) {
  SpringJoint s = soft();
  s.gravity = 0;
  Rod rod(3, s);
  shake(rod, 40);
  reset_springs(rod.springs);
  for (int i = 0; i < 20; ++i) {
    rod.pose({5, 6, 7}, test::axis_angle({0, 0, 1}, 1));
    const std::vector<Affine> animated = rod.scene;
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    for (std::size_t j = 0; j < rod.scene.size(); ++j)
      EXPECT_LT(distance(rod.place(j),
                         {static_cast<double>(animated[j].rows[0][3]), static_cast<double>(animated[j].rows[1][3]),
                          static_cast<double>(animated[j].rows[2][3])}),
                2e-6);
  }
}

// A character that is first seen running is not flung either.
TEST(Springs, TheFirstFramesOfAMovingCharacterAreCalm) {
  SpringJoint s = soft();
  s.gravity = 0;
  s.drag = 0;
  Rod rod(2, s);
  for (int i = 0; i < 60; ++i) {
    rod.pose({0, 0, 8.0 * i / 60});
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    EXPECT_LT(distance(rod.direction(1), {1, 0, 0}), 1e-3) << i;
  }
}

TEST(Springs, BonesKeepTheirLengthAndOnlyRotationsChange) {
  Rod rod(7, soft(), 0.1);
  int cases = 0;
  for (int i = 0; i < 200; ++i) {
    shake(rod, 1, i / 60.0);
    std::vector<SoaTransform> shown = rod.local;
    rod.pose({0.1 * std::sin(9 * i / 60.0), 0.1 * std::cos(7 * i / 60.0), 0},
             test::axis_angle({0.3, 1, 0.2}, std::sin(4 * i / 60.0)));
    for (std::size_t g = 0; g < shown.size(); ++g) {
      EXPECT_EQ(std::memcmp(shown[g].translation, rod.local[g].translation, sizeof shown[g].translation), 0);
      EXPECT_EQ(std::memcmp(shown[g].scale, rod.local[g].scale, sizeof shown[g].scale), 0);
    }
    EXPECT_TRUE(test::same_bits(shown, rod.local, 0));
    std::vector<Affine> scene(rod.scene.size());
    ASSERT_EQ(local_to_model(rod.skeleton, shown, scene), Status::ok);
    for (std::size_t b = 0; b < rod.bones(); ++b, ++cases) {
      const test::Map m = test::to_map(scene[b + 1]);
      EXPECT_NEAR(distance(test::point(m, {0.1, 0, 0}), test::point(m, {0, 0, 0})), 0.1, 1e-6);
    }
  }
  EXPECT_EQ(cases, 200 * 7);
}

TEST(Springs, MatricesFitTheRotations) {
  Rod rod(5, soft(), 0.1);
  shake(rod, 50);
  std::vector<Affine> scene(rod.scene.size());
  ASSERT_EQ(local_to_model(rod.skeleton, rod.local, scene), Status::ok);
  EXPECT_TRUE(same(scene, rod.scene));
}

TEST(Springs, WeightZeroLeavesEveryBitAndTheMotionGoesOn) {
  Rod rod(5, soft(), 0.1), whole(5, soft(), 0.1);
  shake(rod, 30);
  shake(whole, 30);
  for (const bool by_joint : {false, true}) {
    rod.frame.weight = by_joint ? 1.0f : 0.0f;
    for (SpringJoint& s : rod.settings()) s.weight = by_joint ? 0.0f : 1.0f;
    ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
    for (int i = 0; i < 20; ++i) {
      rod.pose({0, 0.01 * i, 0});
      const std::vector<SoaTransform> local = rod.local;
      const std::vector<Affine> scene = rod.scene;
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      EXPECT_TRUE(same(local, rod.local));
      EXPECT_TRUE(same(scene, rod.scene));
      whole.pose({0, 0.01 * i, 0});
      ASSERT_EQ(whole.step(1.0f / 60), Status::ok);
    }
  }
  rod.frame.weight = 1;
  for (SpringJoint& s : rod.settings()) s.weight = 1;
  ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
  shake(rod, 1);
  shake(whole, 1);
  EXPECT_TRUE(same(rod.local, whole.local)) << "as if it had been shown all the time";
}

TEST(Springs, HalfAWeightIsHalfTheAngle) {
  SpringJoint s = soft();
  s.frequency_hz = 1;
  s.damping_ratio = 1;
  Rod rod(1, s), half(1, s);
  half.frame.weight = 0.5f;
  for (int i = 0; i < 600; ++i) {
    rod.pose();
    half.pose();
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    ASSERT_EQ(half.step(1.0f / 60), Status::ok);
  }
  const double angle = std::atan2(rod.direction(0)[1], rod.direction(0)[0]);
  EXPECT_LT(angle, -0.5);
  EXPECT_NEAR(std::atan2(half.direction(0)[1], half.direction(0)[0]), angle / 2, 0.02);
}

// dt 0 stands still; many short frames are as one long one; a very long one is finite and calm.
TEST(Springs, OddFrames) {
  Rod rod(3, soft(), 0.1), other(3, soft(), 0.1);
  shake(rod, 30);
  shake(other, 30);
  for (int i = 0; i < 5; ++i) {  // it stops, and they swing on
    shake(rod, 1, 29 / 60.0);
    shake(other, 1, 29 / 60.0);
  }
  const std::vector<Vec3> before = rod.directions();
  rod.pose({0.1 * std::sin(9 * 29 / 60.0), 0.1 * std::cos(7 * 29 / 60.0), 0},
           test::axis_angle({0.3, 1, 0.2}, std::sin(4 * 29 / 60.0)));
  const std::vector<SoaTransform> posed = rod.local;
  const std::vector<Affine> scene = rod.scene;
  for (int i = 0; i < 10; ++i) {
    rod.local = posed;
    rod.scene = scene;
    ASSERT_EQ(rod.step(0), Status::ok);
    for (std::size_t b = 0; b < rod.bones(); ++b) EXPECT_LT(distance(rod.direction(b), before[b]), 2e-6);
  }
  for (int i = 0; i < 64; ++i) {  // 1/64 s, in 64 pieces that are exact in binary
    rod.local = posed;
    rod.scene = scene;
    ASSERT_EQ(rod.step(1.0f / 4096), Status::ok);
  }
  other.local = posed;
  other.scene = scene;
  ASSERT_EQ(other.step(1.0f / 64), Status::ok);
  for (std::size_t b = 0; b < rod.bones(); ++b) EXPECT_LT(distance(rod.direction(b), other.direction(b)), 5e-3);
  for (const float dt : {1.0f, 1000.0f, 1e9f}) {
    rod.local = posed;
    rod.scene = scene;
    ASSERT_EQ(rod.step(dt), Status::ok);
    for (std::size_t b = 0; b < rod.bones(); ++b) EXPECT_NEAR(test::length(rod.direction(b)), 1, 1e-5);
  }
}

TEST(Springs, BonesWithoutLengthStayAsTheyAre) {
  for (const double length : {0.0, 1e-8}) {
    Rod rod(3, soft(), length);
    for (int i = 0; i < 30; ++i) {
      rod.pose({0, 0.01 * i, 0});
      const std::vector<SoaTransform> local = rod.local;
      if (length == 0) continue;  // tip 0: the last joint only ends the chain
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      EXPECT_TRUE(same(local, rod.local));
    }
  }
  // In the midst of a chain: the bones around it swing.
  std::vector<test::TestJoint> joints(5);
  for (std::size_t i = 1; i < 5; ++i) joints[i] = {static_cast<int>(i) - 1, {i == 3 ? 0 : 0.1, 0, 0}};
  const test::TestSkeleton t(joints);
  const Skeleton skeleton = t.view();
  std::vector<SpringJoint> springs(4, soft());
  for (std::uint16_t i = 0; i < 4; ++i) springs[i].joint = static_cast<std::uint16_t>(i + 1);
  const SpringChain chain{springs, {0.1f, 0, 0}};
  test::AlignedBlock memory(springs_bytes(skeleton, {&chain, 1}));
  Springs s;
  ASSERT_EQ(make_springs(skeleton, {&chain, 1}, {memory.data(), memory.size()}, s), Status::ok);
  std::vector<SoaTransform> local;
  std::vector<Affine> scene(5);
  SpringFrame frame;
  frame.dt_s = 1.0f / 60;
  for (int i = 0; i < 60; ++i) {
    local = t.rest;
    ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
    ASSERT_EQ(simulate_springs({skeleton, local, scene}, frame, s), Status::ok);
  }
  EXPECT_TRUE(test::same_bits(local, t.rest, 2)) << "from joint 2 to 3 is no way";
  EXPECT_FALSE(test::same_bits(local, t.rest, 1));
  EXPECT_FALSE(test::same_bits(local, t.rest, 3));
  for (const Affine& m : scene) EXPECT_TRUE(std::isfinite(m.rows[0][0] + m.rows[1][3]));
}

// Any skeleton, any scale from above (uneven, mirrored, none), any chain: finite, and unit rotations.
TEST(Springs, StayFiniteOnAnything) {
  int cases = 0, chains = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::Poses p(seed, 30, 2);
    test::Random random(seed);
    std::vector<SpringJoint> joints;
    std::uint32_t joint = 29;
    while (true) {  // from a leaf up
      SpringJoint s = soft();
      s.joint = static_cast<std::uint16_t>(joint);
      s.frequency_hz = static_cast<float>(random.between(0, 15));
      s.damping_ratio = static_cast<float>(random.between(0, 1.5));
      s.drag = static_cast<float>(random.between(0, 50));
      joints.insert(joints.begin(), s);
      if (joint < p.skeleton.root_count) break;
      joint = p.skeleton.parents[joint];
    }
    SpringChain chain{joints, {0.1f, 0.2f, 0}};
    chains += joints.size() > 2;
    test::AlignedBlock memory(springs_bytes(p.skeleton, {&chain, 1}));
    Springs s;
    ASSERT_EQ(make_springs(p.skeleton, {&chain, 1}, {memory.data(), memory.size()}, s), Status::ok);
    SpringCollider collider;
    collider.joint = 5;
    collider.radius_m = 1;
    SpringFrame frame;
    frame.colliders = {&collider, 1};
    std::vector<Affine> scene(30);
    for (int i = 0; i < 40; ++i, ++cases) {
      p.out = p.pose[static_cast<std::size_t>(i / 3 % 2)];
      if (seed % 3 == 0) p.out[0].scale[1][0] = 0;
      if (seed % 3 == 1) p.out[0].scale[0][0] = -3e4f;
      ASSERT_EQ(local_to_model(p.skeleton, p.out, scene), Status::ok);
      frame.dt_s = static_cast<float>(random.between(0, 0.2));
      frame.teleport_m = i % 2 == 0 ? 1e6f : 1;
      ASSERT_EQ(simulate_springs({p.skeleton, p.out, scene}, frame, s), Status::ok);
      for (const SpringJoint& j : joints) {
        const test::TestJoint t = test::joint_of(p.out.data(), j.joint);
        double squared = 0;
        for (const double x : t.rotation) squared += x * x;
        EXPECT_NEAR(squared, 1, 1e-5) << seed;
      }
      for (const Affine& m : scene) EXPECT_TRUE(std::isfinite(m.rows[2][3]));
    }
  }
  EXPECT_EQ(cases, 60 * 40);
  EXPECT_GT(chains, 30);
}

TEST(Springs, NewSettingsKeepTheMotion) {
  Rod rod(4, soft(), 0.1), other(4, soft(), 0.1);
  shake(rod, 30);
  shake(other, 30);
  ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
  shake(rod, 10, 0.5);
  shake(other, 10, 0.5);
  EXPECT_TRUE(same(rod.local, other.local));
  for (SpringJoint& s : rod.settings()) s.frequency_hz = 6;
  ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
  shake(rod, 10, 0.7);
  shake(other, 10, 0.7);
  EXPECT_FALSE(same(rod.local, other.local));
  // A copy of the memory is a copy of the motion.
  test::AlignedBlock kept(rod.memory().data(), rod.memory().size());
  shake(rod, 10, 0.9);
  const std::vector<SoaTransform> first = rod.local;
  std::memcpy(rod.memory().data(), kept.data(), kept.size());
  shake(rod, 10, 0.9);
  EXPECT_TRUE(same(first, rod.local));
}

TEST(Springs, BadCallsWriteNothing) {
  Rod rod(3, soft(), 0.1);
  shake(rod, 20);
  rod.pose();
  const test::AlignedBlock kept(rod.memory().data(), rod.memory().size());
  const std::vector<SoaTransform> local = rod.local;
  const std::vector<Affine> scene = rod.scene;
  int refused = 0;
  const auto refuses = [&](auto change) {
    const SpringFrame frame = rod.frame;
    std::vector<Affine> matrices = scene;
    rod.frame.dt_s = 1.0f / 60;
    change(rod.frame, matrices);
    EXPECT_EQ(simulate_springs({rod.skeleton, rod.local, matrices}, rod.frame, rod.springs), Status::bad_argument)
        << refused;
    EXPECT_TRUE(same(local, rod.local));
    EXPECT_EQ(std::memcmp(kept.data(), rod.memory().data(), kept.size()), 0);
    rod.frame = frame;
    ++refused;
  };
  using F = SpringFrame&;
  using M = std::vector<Affine>&;
  std::vector<SpringCollider> colliders(1);
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    refuses([&](F f, M) { f.dt_s = bad; });
    refuses([&](F f, M) { f.gravity[1] = bad; });
    refuses([&](F f, M) { f.wind[2] = bad; });
    refuses([&](F f, M) { f.teleport_m = bad; });
    refuses([&](F f, M) { f.weight = bad; });
    refuses([&](F f, M) { f.world_from_model.rows[1][2] = bad; });
    for (std::size_t j = 0; j < 4; ++j) refuses([&](F, M m) { m[j].rows[2][3] = bad; });
    refuses([&](F f, M) { colliders[0] = {0, 0, {0, bad, 0}, {0, 0, 0}, 1}, f.colliders = colliders; });
    refuses([&](F f, M) { colliders[0] = {0, 0, {0, 0, 0}, {0, 0, bad}, 1}, f.colliders = colliders; });
    refuses([&](F f, M) { colliders[0] = {0, 0, {0, 0, 0}, {0, 0, 0}, bad}, f.colliders = colliders; });
  }
  refuses([&](F f, M) { f.dt_s = -0.001f; });
  refuses([&](F f, M) { f.weight = 1.001f; });
  refuses([&](F f, M) { colliders[0] = {4, 0, {0, 0, 0}, {0, 0, 0}, 1}, f.colliders = colliders; });
  refuses([&](F f, M) { colliders.assign(kMaxSpringColliders + 1, {}), f.colliders = colliders; });
  refuses([&](F, M m) { m.pop_back(); });
  EXPECT_EQ(refused, 3 * 13 + 5);
  EXPECT_EQ(simulate_springs({rod.skeleton, {rod.local.data(), 0}, rod.scene}, rod.frame, rod.springs),
            Status::bad_argument);
}

TEST(Springs, BadChainsAreRefused) {
  Rod rod(3, soft(), 0.1);
  const Springs before = rod.springs;
  const test::AlignedBlock kept(rod.memory().data(), rod.memory().size());
  int refused = 0;
  const auto refuses = [&](const std::vector<SpringJoint>& joints, float tip, std::size_t bytes) {
    const SpringChain chain{joints, {tip, 0, 0}};
    EXPECT_EQ(make_springs(rod.skeleton, {&chain, 1}, {rod.memory().data(), bytes}, rod.springs), Status::bad_argument)
        << refused;
    if (bytes == rod.memory().size()) {
      EXPECT_EQ(set_springs(rod.skeleton, {&chain, 1}, rod.springs), Status::bad_argument) << refused;
    }
    EXPECT_EQ(rod.springs.group_count, before.group_count);
    EXPECT_EQ(std::memcmp(kept.data(), rod.memory().data(), kept.size()), 0);
    ++refused;
  };
  const std::vector<SpringJoint> good = rod.settings();
  const std::size_t all = rod.memory().size();
  refuses(good, 0.1f, all - 1);
  refuses({}, 0.1f, all);
  refuses({good[0]}, 0, all);
  refuses(good, kNan, all);
  refuses({good[1], good[0], good[2]}, 0.1f, all);
  refuses({good[0], good[0], good[2]}, 0.1f, all);
  const auto with = [&](auto change) {
    std::vector<SpringJoint> joints = good;
    change(joints[1]);
    refuses(joints, 0.1f, all);
  };
  with([](SpringJoint& s) { s.joint = 4; });
  for (const float bad : {kNan, kInfinity, -11.0f, 100.0f}) {
    with([&](SpringJoint& s) { s.frequency_hz = bad; });
    with([&](SpringJoint& s) { s.damping_ratio = bad; });
    with([&](SpringJoint& s) { s.gravity = bad; });
    with([&](SpringJoint& s) { s.drag = bad; });
    with([&](SpringJoint& s) { s.weight = bad; });
    if (bad != 100.0f) with([&](SpringJoint& s) { s.radius_m = bad; });
  }
  EXPECT_EQ(refused, 7 + 23);
  EXPECT_EQ(make_springs(rod.skeleton, {&rod.chain(), 1}, {rod.memory().data() + 4, all}, rod.springs),
            Status::bad_argument)
      << "off the boundary";
  EXPECT_EQ(make_springs(rod.skeleton, {}, {}, rod.springs), Status::ok) << "no chains, no memory";
  EXPECT_EQ(rod.step(0.01f), Status::ok);
}

TEST(Springs, AllocateNothing) {
  Rod rod(6, soft(), 0.1);
  SpringCollider ball;
  ball.from[1] = ball.to[1] = -0.2f;
  rod.frame.colliders = {&ball, 1};
  rod.frame.dt_s = 1.0f / 60;
  int failures = 0;
  const std::size_t before = test::allocation_count();
  for (int i = 0; i < 1000; ++i) {
    rod.frame.world_from_model.rows[0][3] = 0.01f * static_cast<float>(i % 40);
    failures += simulate_springs({rod.skeleton, rod.local, rod.scene}, rod.frame, rod.springs) != Status::ok;
    failures += set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

// The same bits on every processor, with SIMD or without.
TEST(Springs, SameBitsEverywhere) {
  Rod rod(9, soft(), 0.1);
  SpringCollider bar;
  bar.from[0] = 0.1f, bar.to[0] = 0.4f, bar.from[1] = bar.to[1] = -0.2f;
  rod.frame.colliders = {&bar, 1};
  test::Random random(77);
  std::uint64_t state = test::kHashStart;
  for (int i = 0; i < 300; ++i) {
    const Vec3 at{random.between(0, 0.05), random.between(0, 0.05), 0};
    rod.pose(at, test::normalised(test::Quat{0, random.between(-0.25, 0.25), 0, 1}));
    ASSERT_EQ(rod.step(static_cast<float>(random.between(0.002, 0.04))), Status::ok);
    state = test::hash(state, rod.local.data(), rod.local.size() * sizeof(SoaTransform));
    state = test::hash(state, rod.scene.data(), rod.scene.size() * sizeof(Affine));
  }
  EXPECT_EQ(state, 0x3227d99b8e7a79c0u) << std::hex << state;
}

}  // namespace
}  // namespace marrow
