// Inertialisation: what it promises at its start, at its end and between, and its curve in double precision.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/transition.h"
#include "support/expect_joint.h"
#include "support/poses.h"

namespace marrow {
namespace {

constexpr float kFrame = 1.0f / 64, kDuration = 0.5f;

// A pose that has moved on from `pose`: a small turn and a small shift for each joint.
std::vector<SoaTransform> moved(const std::vector<SoaTransform>& pose, std::uint64_t seed, double amount) {
  test::Random random(seed);
  std::vector<test::TestJoint> joints;
  for (std::size_t j = 0; j < pose.size() * 4; ++j) {
    test::TestJoint t = test::joint_of(pose.data(), j);
    for (double& x : t.translation) x += random.between(-amount, amount);
    for (double& x : t.scale) x += random.between(-amount, amount);
    for (double& x : t.rotation) x += random.between(-amount, amount);
    t.rotation = test::normalised(t.rotation);
    joints.push_back(t);
  }
  return test::TestSkeleton(joints).rest;
}

struct Scene {
  explicit Scene(std::uint64_t seed, std::size_t joints = 24)
      : p(seed, joints, 1),
        before(p.pose[0]),
        now(moved(before, seed + 1, 0.02)),
        target(moved(now, seed + 2, 0.5)),
        target_was(moved(target, seed + 3, 0.02)),
        memory(p.groups()) {
    inertia.offsets = memory;
  }
  Status begin(bool target_moves) {
    const Span<const SoaTransform> was =
        target_moves ? Span<const SoaTransform>(target_was) : Span<const SoaTransform>();
    return begin_inertia(p.skeleton, {before, now, target, was, kFrame}, kDuration, inertia);
  }
  std::vector<SoaTransform> shown(float time_s, const std::vector<SoaTransform>& pose) {
    std::vector<SoaTransform> out = pose;
    EXPECT_EQ(apply_inertia(p.skeleton, inertia, time_s, out), Status::ok);
    return out;
  }

  test::Poses p;
  std::vector<SoaTransform> before, now, target, target_was;
  std::vector<InertialOffset> memory;
  Inertia inertia;
};

TEST(Inertia, BeginsWithThePoseThatWasShown) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Scene s(seed);
    ASSERT_EQ(s.begin(seed % 2 == 0), Status::ok);
    for (const float time_s : {0.0f, -1.0f}) {
      const std::vector<SoaTransform> out = s.shown(time_s, s.target);
      for (std::size_t j = 0; j < 24; ++j, ++cases)
        test::expect_joint(test::joint_of(out.data(), j), test::joint_of(s.now.data(), j), 3e-6);
    }
  }
  EXPECT_EQ(cases, 30 * 2 * 24);
}

// The speed with which each component leaves is that with which it came, for a new clip that stands still.
TEST(Inertia, BeginsWithTheVelocityThatWasShown) {
  const double step = 1e-3;
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Scene s(seed);
    ASSERT_EQ(s.begin(false), Status::ok);
    const std::vector<SoaTransform> first = s.shown(0, s.target), next = s.shown(static_cast<float>(step), s.target);
    for (std::size_t j = 0; j < 24; ++j) {
      const test::TestJoint a = test::joint_of(s.before.data(), j), b = test::joint_of(s.now.data(), j);
      const test::TestJoint c = test::joint_of(first.data(), j), d = test::joint_of(next.data(), j);
      const auto expect_speed = [&](double was, double is) {
        ++cases;
        EXPECT_NEAR(is / step, was / static_cast<double>(kFrame), 0.1) << seed << ", joint " << j;
      };
      // What ends within a few steps is braked too hard for a difference of two frames to show its speed.
      const auto& rate = s.memory[j / 4].rate;
      const auto slow = [&](std::size_t i) { return rate[i][j % 4] < 10.0f; };
      for (std::size_t i = 0; i < 3; ++i) {
        if (slow(i)) expect_speed(b.translation[i] - a.translation[i], d.translation[i] - c.translation[i]);
        if (slow(6 + i)) expect_speed(b.scale[i] - a.scale[i], d.scale[i] - c.scale[i]);
      }
      if (!slow(3) || !slow(4) || !slow(5)) continue;
      for (std::size_t i = 0; i < 4; ++i) expect_speed(b.rotation[i] - a.rotation[i], d.rotation[i] - c.rotation[i]);
    }
  }
  EXPECT_GT(cases, 4000);
}

// Bollo's quintic with the coefficients of the talk, for each component.
TEST(Inertia, FollowsTheQuintic) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scene s(seed);
    ASSERT_EQ(s.begin(true), Status::ok);
    for (std::size_t j = 0; j < 24; ++j) {
      const test::TestJoint old_was = test::joint_of(s.before.data(), j), old_is = test::joint_of(s.now.data(), j);
      const test::TestJoint new_was = test::joint_of(s.target_was.data(), j),
                            new_is = test::joint_of(s.target.data(), j);
      for (std::size_t i = 0; i < 3; ++i) {
        const double x0 = old_is.translation[i] - new_is.translation[i];
        const double v0 = (x0 - (old_was.translation[i] - new_was.translation[i])) / static_cast<double>(kFrame);
        double t1 = static_cast<double>(kDuration);
        if (v0 / x0 < 0) t1 = std::fmin(t1, -5 * x0 / v0);
        const double a0 = (-8 * v0 * t1 - 20 * x0) / (t1 * t1);
        const double a = -(a0 * t1 * t1 + 6 * v0 * t1 + 12 * x0) / (2 * std::pow(t1, 5));
        const double b = (3 * a0 * t1 * t1 + 16 * v0 * t1 + 30 * x0) / (2 * std::pow(t1, 4));
        const double c = -(3 * a0 * t1 * t1 + 12 * v0 * t1 + 20 * x0) / (2 * std::pow(t1, 3));
        for (int k = 0; k <= 10; ++k, ++cases) {
          const double t = std::fmin(t1, k * 0.05);
          const double want = ((((a * t + b) * t + c) * t + a0 / 2) * t + v0) * t + x0;
          const std::vector<SoaTransform> out = s.shown(static_cast<float>(k * 0.05), s.target);
          EXPECT_NEAR(test::joint_of(out.data(), j).translation[i] - new_is.translation[i], want, 2e-5);
        }
      }
    }
  }
  EXPECT_EQ(cases, 10 * 24 * 3 * 11);
}

TEST(Inertia, EndsInTheNewPoseBitForBitAndBeforeThatComesNear) {
  Scene s(5);
  EXPECT_TRUE(s.p.same(s.shown(0, s.target), s.target)) << "before any transition";
  ASSERT_EQ(s.begin(true), Status::ok);
  for (const float time_s : {kDuration, 0.6f, std::numeric_limits<float>::infinity()})
    EXPECT_TRUE(s.p.same(s.shown(time_s, s.target), s.target));
  const std::vector<SoaTransform> near = s.shown(0.499f, s.target);
  for (std::size_t j = 0; j < 24; ++j)
    test::expect_joint(test::joint_of(near.data(), j), test::joint_of(s.target.data(), j), 1e-6);
}

TEST(Inertia, NoComponentOfTheOffsetChangesItsSign) {
  int cases = 0, shortened = 0, growing = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Scene s(seed);
    if (seed % 4 == 0) s.target = moved(s.now, seed, 0.001);    // near, so that most would overshoot
    if (seed % 8 == 0) s.target[0] = s.now[0];                  // no offset at all
    if (seed % 5 == 0) s.before = moved(s.now, seed + 9, 0.9);  // a wild jump
    ASSERT_EQ(s.begin(false), Status::ok);
    // A joint's components seen through the curve itself: shown - target, from a target of zeros.
    const SoaTransform zero{};
    for (std::size_t g = 0; g < s.memory.size(); ++g) {
      const InertialOffset& o = s.memory[g];
      for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t l = 0; l < 4; ++l) {
          shortened += o.rate[i][l] > 2.0f;
          growing += o.slope[i][l] * o.start[i][l] > 4.001f * o.start[i][l] * o.start[i][l];
        }
      }
    }
    const std::vector<SoaTransform> still(s.p.groups(), zero);
    std::vector<float> sign(s.p.groups() * 24, 0.0f);
    for (int k = 0; k < 200; ++k) {
      const std::vector<SoaTransform> out = s.shown(static_cast<float>(k) * kDuration / 199.5f, still);
      for (std::size_t g = 0; g < out.size(); ++g) {
        for (std::size_t i = 0; i < 6; ++i) {
          for (std::size_t l = 0; l < 4; ++l, ++cases) {
            const float x = i < 3 ? out[g].translation[i][l] : out[g].scale[i - 3][l];
            float& was = sign[(g * 6 + i) * 4 + l];
            EXPECT_GE(x * was, 0.0f) << seed << ": component " << i << " of joint " << 4 * g + l << " at step " << k;
            if (x != 0) was = x > 0 ? 1.0f : -1.0f;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 40 * 200 * 24 * 6);
  EXPECT_GT(shortened, 1000);
  EXPECT_GT(growing, 300);
}

TEST(Inertia, HalfTurnsAndWildVelocitiesStayUnitQuaternions) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Scene s(seed);
    s.target = test::noise_pose(seed + 500, 24);  // any turn up to half a one
    if (seed % 2 == 0) s.before = test::noise_pose(seed + 600, 24);
    ASSERT_EQ(s.begin(seed % 3 == 0), Status::ok);
    for (int k = 0; k < 32; ++k) {
      const std::vector<SoaTransform> out = s.shown(static_cast<float>(k) / 64, s.target);
      for (std::size_t j = 0; j < 24; ++j, ++cases) {
        const test::TestJoint t = test::joint_of(out.data(), j);
        double squared = 0;
        for (const double x : t.rotation) squared += x * x;
        ASSERT_NEAR(squared, 1, 1e-6);
        if (k == 0) test::expect_joint(t, test::joint_of(s.now.data(), j), 4e-6);
      }
    }
  }
  EXPECT_EQ(cases, 60 * 32 * 24);
}

TEST(Inertia, BadCalls) {
  Scene s(7);
  const std::size_t few = s.p.groups() - 1;
  const auto refused = [&](InertialStart start, float duration_s = 0.5f) {
    EXPECT_EQ(begin_inertia(s.p.skeleton, start, duration_s, s.inertia), Status::bad_argument);
  };
  const InertialStart good{s.before, s.now, s.target, s.target_was, kFrame};
  for (Span<const SoaTransform> InertialStart::*const pose :
       {&InertialStart::before, &InertialStart::now, &InertialStart::target, &InertialStart::target_was}) {
    InertialStart bad = good;
    (bad.*pose).size = few;
    refused(bad);
  }
  for (const float x : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    InertialStart bad = good;
    bad.frame_s = x;
    refused(bad);
    refused(good, x);
  }
  s.inertia.offsets.size = few;
  refused(good);
  EXPECT_EQ(s.inertia.duration_s, 0.0f) << "nothing has begun";
  s.inertia.offsets.size = few + 1;
  ASSERT_EQ(s.begin(true), Status::ok);
  EXPECT_EQ(apply_inertia(s.p.skeleton, s.inertia, 0.1f, {s.now.data(), few}), Status::bad_argument);
  EXPECT_EQ(apply_inertia(s.p.skeleton, s.inertia, std::nanf(""), s.now), Status::bad_argument);
  s.inertia.offsets.size = few;
  EXPECT_EQ(apply_inertia(s.p.skeleton, s.inertia, 0.1f, s.now), Status::bad_argument);
}

// The shortest frames, the longest fades, and poses as far apart as they may be.
TEST(Inertia, StaysFiniteWithinItsRanges) {
  int cases = 0;
  for (const float far : {0.0f, 1e-40f, 1.0f, 1e9f, 1e15f}) {
    for (const float frame_s : {1e-45f, 1e-38f, 1e-20f, 1e-6f, 1.0f, 3e38f}) {
      for (const float duration_s : {1e-45f, 1e-38f, 1e-6f, 1.0f, 1e6f}) {
        Scene s(5);
        for (auto& axis : s.now[0].translation) axis[0] += far, axis[1] -= far;
        for (auto& axis : s.target[0].scale) axis[0] += far, axis[2] -= far;
        for (auto& axis : s.target_was[0].translation) axis[1] += far, axis[3] -= far;
        ASSERT_EQ(
            begin_inertia(s.p.skeleton, {s.before, s.now, s.target, s.target_was, frame_s}, duration_s, s.inertia),
            Status::ok);
        for (const float time_s : {0.0f, 1e-45f, 0.3f * duration_s, 0.999f * duration_s}) {
          for (const SoaTransform& t : s.shown(time_s, s.target)) {
            for (int i = 0; i < 3; ++i, ++cases)
              for (int lane = 0; lane < 4; ++lane)
                ASSERT_TRUE(std::isfinite(t.translation[i][lane]) && std::isfinite(t.scale[i][lane]))
                    << far << ' ' << frame_s << ' ' << duration_s << ' ' << time_s;
            for (const auto& row : t.rotation)
              for (const float x : row) ASSERT_TRUE(std::isfinite(x)) << far << ' ' << frame_s << ' ' << duration_s;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 5 * 6 * 5 * 4 * 6 * 3);
  Scene s(5);
  EXPECT_EQ(begin_inertia(s.p.skeleton, {s.before, s.now, s.target, {}, kFrame}, 1.1e6f, s.inertia),
            Status::bad_argument);
}

}  // namespace
}  // namespace marrow
