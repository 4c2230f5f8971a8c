// Joint limits: what is outside comes inside, what is inside stays, and nothing jumps.
#include "marrow/limits.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "support/bad_numbers.h"
#include "unit/ik/limit_reference.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;

using namespace test;

JointLimit made(const LimitDescription& d, std::uint16_t joint = 0) {
  JointLimit limit = {};
  EXPECT_EQ(make_limit(d, joint, limit), Status::ok);
  EXPECT_TRUE(is_valid(limit));
  return limit;
}

struct Turned {
  float q[4];
  Mat3 matrix() const { return test::matrix(quat(q)); }
};
Turned turned(const Quat& q) {
  Turned t;
  set(t.q, q);
  return t;
}
Turned clamp(const JointLimit& limit, Turned t) {
  EXPECT_EQ(clamp_rotation(limit, t.q), Status::ok);
  return t;
}
bool same_bits(const Turned& a, const Turned& b) {
  return std::memcmp(a.q, b.q, sizeof a.q) == 0;
}

constexpr float kDegree = 0.0174532925f;

LimitDescription knee() {  // bends from 0° to 150° about x
  LimitDescription d;
  d.kind = LimitKind::hinge;
  d.most_rad[0] = 150 * kDegree;
  return d;
}

TEST(Limits, AKneeStopsWhereItShould) {
  const JointLimit limit = made(knee());
  // 255° is opposite the middle, and a quarter of the way before it, as tangents of a quarter, 159.4° from the middle.
  const double pairs[][2] = {{20, 20}, {149.9, 149.9}, {170, 150}, {230, 150}, {-30, 0}, {-80, 0}, {-105, 75}};
  for (const auto& [from, to] : pairs) {
    const Turned after = clamp(limit, turned(axis_angle({1, 0, 0}, from * kPi / 180)));
    EXPECT_LT(angle_between(after.matrix(), about(0, to * kPi / 180)), 3e-6) << from;
  }
  // A turn about another axis is undone.
  const Mat3 aside = matrix(axis_angle({0, 1, 0}, 0.5)) * about(0, 1);
  EXPECT_LT(angle_between(clamp(limit, turned(quat(aside))).matrix(), about(0, 1)), 1e-6);
  EXPECT_NEAR(limit_excess(limit, turned(quat(aside)).q), 0.5, 1e-6);
}

TEST(Limits, AConeHasItsTwoRadii) {
  LimitDescription d;
  d.kind = LimitKind::cone;
  d.most_rad[1] = 40 * kDegree;  // about y
  d.most_rad[2] = 70 * kDegree;  // about z
  d.least_rad[1] = -d.most_rad[1];
  d.least_rad[2] = -d.most_rad[2];
  d.least_rad[0] = -10 * kDegree;
  d.most_rad[0] = 30 * kDegree;
  const JointLimit limit = made(d);
  const double turns[][3] = {{1, 60, 40}, {1, -60, -40}, {2, 90, 70}, {2, 65, 65}, {0, 50, 30}, {0, -90, -10}};
  for (const auto& [axis, from, to] : turns) {
    const auto a = static_cast<std::size_t>(axis);
    const Turned after = clamp(limit, turned(quat(about(a, from * kPi / 180))));
    EXPECT_LT(angle_between(after.matrix(), about(a, to * kPi / 180)), 3e-6) << axis << " " << from;
  }
}

TEST(Limits, AConeMayBeFlat) {
  LimitDescription d;
  d.kind = LimitKind::cone;
  EXPECT_NEAR(limit_excess(made(d), turned(quat(about(1, 1))).q), 1, 1e-5);  // nothing but its zero
  d.most_rad[1] = 40 * kDegree;
  d.least_rad[1] = -d.most_rad[1];
  const JointLimit limit = made(d);
  const double turns[][3] = {{1, 60, 40}, {1, -90, -40}, {1, 30, 30}, {2, 30, 0}, {2, -1, 0}, {0, 20, 0}};
  for (const auto& [axis, from, to] : turns) {
    const auto a = static_cast<std::size_t>(axis);
    const Turned after = clamp(limit, turned(quat(about(a, from * kPi / 180))));
    EXPECT_LT(angle_between(after.matrix(), about(a, to * kPi / 180)), 1e-5) << axis << " " << from;
  }
}

TEST(Limits, AnglesAreInTheJointsAxesFromItsZero) {
  LimitDescription d = knee();
  set(d.zero, axis_angle({0, 0, 1}, kPi / 2));  // the joint's x is the parent's y
  d.axis[0] = 0;
  d.axis[1] = 1;  // the joint's y, the parent's -x
  d.across[0] = 1;
  const JointLimit limit = made(d);
  const Turned beyond = turned(quat(about(2, kPi / 2) * about(1, 3)));
  EXPECT_LT(angle_between(clamp(limit, beyond).matrix(), about(2, kPi / 2) * about(1, 150 * kPi / 180)), 3e-6);
  EXPECT_LT(angle_between(clamp(limit, beyond).matrix(), about(0, -150 * kPi / 180) * about(2, kPi / 2)), 3e-6);
}

TEST(Limits, MayReachGimbalLock) {
  LimitDescription d;
  d.kind = LimitKind::euler;
  d.least_rad[1] = -90 * kDegree;
  d.most_rad[1] = 90 * kDegree;
  d.least_rad[0] = -1;
  d.most_rad[0] = 1;
  const JointLimit limit = made(d);
  int cases = 0;
  for (int i = -100; i <= 100; ++i, ++cases) {
    const Turned t = turned(quat(about(0, i / 100.0) * about(1, kPi / 2)));
    EXPECT_TRUE(same_bits(clamp(limit, t), t)) << i;
    const Turned beyond = turned(quat(about(0, i / 100.0) * about(1, kPi / 2) * about(2, 0.1)));
    const Turned after = clamp(limit, beyond);
    EXPECT_LT(angle_between(after.matrix(), beyond.matrix()), 0.1001);
    EXPECT_TRUE(same_bits(clamp(limit, after), after)) << i;
  }
  EXPECT_EQ(cases, 201);
}

TEST(Limits, AWholeTurnIsNoLimit) {
  LimitDescription d = knee();
  d.least_rad[0] = -180 * kDegree;
  d.most_rad[0] = 180 * kDegree;
  const JointLimit limit = made(d);
  for (int i = -36; i <= 36; ++i) {
    const Turned t = turned(quat(about(0, i * kPi / 36)));
    EXPECT_TRUE(same_bits(clamp(limit, t), t)) << i;
  }
}

TEST(Limits, KeepTheHemisphere) {
  LimitRandom random(5);
  for (int i = 0; i < 3000; ++i) {
    const Turned before = turned(any_rotation(random));
    const Turned after = clamp(made(any_limit(random, kAllKinds[i % 3])), before);
    double d = 0;
    for (std::size_t c = 0; c < 4; ++c) d += static_cast<double>(before.q[c]) * static_cast<double>(after.q[c]);
    EXPECT_GE(d, 0);
  }
}

TEST(Limits, OfAPoseTurnTheirJointsAlone) {
  std::array<SoaTransform, 3> pose = {};
  const Quat bent = axis_angle({1, 0, 0}, 3);
  for (SoaTransform& group : pose)
    for (std::size_t c = 0; c < 4; ++c)
      for (float& lane : group.rotation[c]) lane = static_cast<float>(bent[c]);
  pose[1].rotation[3][1] = kNan;
  const std::array<SoaTransform, 3> before = pose;
  const JointLimit limits[] = {made(knee(), 1), made(knee(), 5), made({}, 6), made(knee(), 11)};
  ASSERT_EQ(limit_pose({limits, 4}, pose), Status::ok);
  int changed = 0;
  for (std::size_t joint = 0; joint < 12; ++joint) {
    const bool limited = joint == 1 || joint == 11;
    const float x = pose[joint / 4].rotation[0][joint % 4], was = before[joint / 4].rotation[0][joint % 4];
    EXPECT_NEAR(x, limited ? std::sin(75 * kPi / 180) : double{was}, limited ? 1e-6 : 0) << joint;
    changed += std::memcmp(&x, &was, sizeof x) != 0;
  }
  EXPECT_EQ(changed, 2);
  EXPECT_EQ(find_limit({limits, 4}, 5), &limits[1]);
  EXPECT_EQ(find_limit({limits, 4}, 11), &limits[3]);
  EXPECT_EQ(find_limit({limits, 4}, 0), nullptr);
  EXPECT_EQ(find_limit({limits, 4}, 12), nullptr);
  EXPECT_EQ(find_limit({}, 0), nullptr);
  // Beyond the pose: nothing is written.
  pose = before;
  EXPECT_EQ(limit_pose({limits, 4}, Span<SoaTransform>(pose.data(), 2)), Status::bad_argument);
  EXPECT_EQ(std::memcmp(&pose, &before, sizeof pose), 0);
}

TEST(Limits, RefuseBadDescriptions) {
  using Spoil = void (*)(LimitDescription&);
  const Spoil bad[] = {
      [](LimitDescription& d) { d.kind = static_cast<LimitKind>(4); },
      [](LimitDescription& d) { d.order = static_cast<AxisOrder>(6); },
      [](LimitDescription& d) { d.zero[3] = 0; },
      [](LimitDescription& d) { d.zero[0] = kNan; },
      [](LimitDescription& d) { d.axis[0] = 0; },
      [](LimitDescription& d) { d.axis[2] = kInfinity; },
      [](LimitDescription& d) { d.across[0] = 1, d.across[1] = 0; },
      [](LimitDescription& d) { d.least_rad[0] = 3; },
      [](LimitDescription& d) { d.most_rad[0] = 7; },
      [](LimitDescription& d) { d.most_rad[0] = kNan; },
      [](LimitDescription& d) { d.rate.speed = -1; },
      [](LimitDescription& d) { d.rate.acceleration = kInfinity; },
      [](LimitDescription& d) { d.kind = LimitKind::cone, d.most_rad[1] = 3.1f, d.least_rad[1] = -3.1f; },
      [](LimitDescription& d) { d.kind = LimitKind::cone, d.most_rad[2] = 1, d.least_rad[2] = 0; },
      [](LimitDescription& d) { d.kind = LimitKind::euler, d.most_rad[1] = 1.6f; },
      [](LimitDescription& d) { d.kind = LimitKind::euler, d.least_rad[2] = 1; },
  };
  int cases = 0;
  for (const Spoil spoil : bad) {
    LimitDescription d = knee();
    spoil(d);
    JointLimit out = {};
    out.joint = 77;
    EXPECT_EQ(make_limit(d, 3, out), Status::bad_argument) << cases;
    EXPECT_EQ(out.joint, 77);
    ++cases;
  }
  EXPECT_EQ(cases, 16);
}

TEST(Limits, RefuseWhatIsNoRotation) {
  const JointLimit limit = made(knee());
  for (const float bad : {0.0f, kNan, kInfinity}) {
    float q[4] = {bad, 0, 0, 0}, was[4] = {bad, 0, 0, 0};
    EXPECT_EQ(clamp_rotation(limit, q), Status::bad_argument);
    EXPECT_EQ(std::memcmp(q, was, sizeof q), 0);
    EXPECT_EQ(limit_excess(limit, q), 0);
  }
}

TEST(Limits, AreNeverBroken) {
  LimitRandom random(1);
  int cases = 0, outside_before = 0;
  double worst = 0;
  for (int i = 0; i < 100000; ++i, ++cases) {
    const LimitDescription d = any_limit(random, kAllKinds[i % 3], i % 2 == 0 ? 2.5 : 0.6);
    const JointLimit limit = made(d);
    const Turned before = turned(any_rotation(random)), after = clamp(limit, before);
    outside_before += reference_excess(d, before.matrix()) > 1e-4;
    worst = std::max(worst, reference_excess(d, after.matrix()));
    ASSERT_LT(worst, 1e-4) << i;
    EXPECT_TRUE(same_bits(clamp(limit, after), after)) << i;
    EXPECT_NEAR(limit_excess(limit, before.q), angle_between(before.matrix(), after.matrix()), 3e-6) << i;
    EXPECT_EQ(limit_excess(limit, after.q), 0);
  }
  EXPECT_EQ(cases, 100000);
  EXPECT_GT(outside_before, 80000);
}

TEST(Limits, InsideKeepsItsBits) {
  LimitRandom random(2);
  int cases = 0;
  for (int i = 0; i < 30000; ++i, ++cases) {
    const LimitDescription d = any_limit(random, kAllKinds[i % 3]);
    const JointLimit limit = made(d);
    // Every fourth on a corner of the limit.
    const auto share = [&] { return i % 4 == 3 ? static_cast<double>(random() % 2) : uniform(random, 0, 1); };
    const double u = share(), v = share(), w = share();
    const Mat3 m = rotation_inside(d, u, v, w);
    ASSERT_LT(reference_excess(d, m), 1e-6);
    Quat q = quat(m);
    if (i % 2 == 0) q = {-q[0], -q[1], -q[2], -q[3]};
    const Turned t = turned(q);
    EXPECT_TRUE(same_bits(clamp(limit, t), t)) << i << " " << limit_excess(limit, t.q);
  }
  EXPECT_EQ(cases, 30000);
}

double jump(const JointLimit& limit, const Quat& a, const Quat& b) {
  return angle_between(clamp(limit, turned(a)).matrix(), clamp(limit, turned(b)).matrix());
}

TEST(Limits, MoveContinuously) {
  LimitRandom random(3);
  int steps = 0;
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const LimitDescription d = any_limit(random, kAllKinds[i % 3], 2.0);
    const JointLimit limit = made(d);
    const Quat from = any_rotation(random), to = any_rotation(random);
    Quat last = from;
    for (int k = 1; k <= 200; ++k, ++steps) {
      Quat a = last, b = slerp(from, to, k / 200.0);
      last = b;
      // Of every step the half with the greater part of the movement, down to the steps of floats.
      double moved = jump(limit, a, b);
      for (int half = 0; half < 16 && moved > 0.003; ++half) {
        const Quat middle = slerp(a, b, 0.5);
        const double first = jump(limit, a, middle), second = jump(limit, middle, b);
        (first > second ? b : a) = middle;
        moved = std::max(first, second);
      }
      worst = std::max(worst, moved);
    }
  }
  EXPECT_EQ(steps, 60000);
  EXPECT_LT(worst, 0.01);
}

TEST(Limits, AreContinuousWhereTwistIsLost) {
  LimitRandom random(4);
  int cases = 0;
  for (int i = 0; i < 600; ++i) {
    const LimitDescription d = any_limit(random, i % 2 == 0 ? LimitKind::hinge : LimitKind::cone, 2.0);
    const JointLimit limit = made(d);
    const double away = uniform(random, 0, 2 * kPi);
    const Quat half_turn = axis_angle({0, std::cos(away), std::sin(away)}, kPi - 1e-5);
    Turned first = {};
    for (int k = 0; k < 32; ++k, ++cases) {
      const Mat3 t = matrix(half_turn) * about(0, 2 * kPi * k / 32);
      const Turned after = clamp(limit, turned(quat(from_limit_axes(d, t))));
      if (k == 0) first = after;
      EXPECT_LT(angle_between(first.matrix(), after.matrix()), 1e-3) << i << " " << k;
    }
  }
  EXPECT_EQ(cases, 600 * 32);
}

// The least angle from a rotation to the limit: tries everywhere, then ever nearer to the best.
double nearest_angle(const LimitDescription& d, const Mat3& from, LimitRandom& random) {
  double best = 10;
  std::array<double, 3> place = {};
  for (int i = 0; i < 300; ++i) {
    const std::array<double, 3> p = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
    const double angle = angle_between(from, rotation_inside(d, p[0], p[1], p[2]));
    if (angle < best) best = angle, place = p;
  }
  double step = 0.2;
  for (int i = 0; i < 700; ++i) {
    std::array<double, 3> p = place;
    for (double& x : p) x = std::clamp(x + uniform(random, -step, step), 0.0, 1.0);
    const double angle = angle_between(from, rotation_inside(d, p[0], p[1], p[2]));
    if (angle < best) {
      best = angle, place = p;
    } else {
      step = std::max(1e-5, step * 0.985);
    }
  }
  return best;
}

// The figures of docs/ik/limits.md: up to a radian from a rotation inside ranges of up to 86° to each side.
TEST(Limits, AreLeftForWhatIsNearlyTheNearest) {
  const double medians[] = {1e-3, 0.01, 1e-3}, most_of_20[] = {1e-3, 0.15, 0.02};
  LimitRandom random(6);
  for (int kind = 0; kind < 3; ++kind) {
    std::vector<double> more;
    while (more.size() < 200) {
      const LimitDescription d = any_limit(random, kAllKinds[kind], 1.5);
      const JointLimit limit = made(d);
      const Mat3 in = rotation_inside(d, uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
      const Vec3 axis = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
      const Turned q = turned(quat(in * matrix(axis_angle(axis, uniform(random, 0, 1)))));
      const double excess = static_cast<double>(limit_excess(limit, q.q));
      if (excess > 1e-2) more.push_back(excess / nearest_angle(d, q.matrix(), random) - 1);
    }
    std::sort(more.begin(), more.end());
    EXPECT_LT(more[100], medians[kind]) << kind;
    EXPECT_LT(more[190], most_of_20[kind]) << kind;
  }
}

}  // namespace
}  // namespace marrow
