// Limits over time: the same path at every frame rate, within speed and acceleration, to the target and no farther.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "marrow/limits.h"
#include "support/allocations.h"
#include "support/rig.h"
#include "unit/ik/limit_reference.h"

namespace marrow {
namespace {

using namespace test;

constexpr int kRates[] = {15, 20, 24, 30, 48, 50, 60, 72, 75, 90, 100, 120, 144, 165, 200, 240};
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

// From rest over `way` to a target at rest, in double precision and steps of a microsecond: full acceleration, full
// speed, then down the curve v² = 2 b d - (b / 120)² with b nine tenths of the acceleration, and at last v = 120 d.
class Ideal {
 public:
  Ideal(double way, double speed, double acceleration, double until_s) {
    const double b = 0.9 * acceleration, step = 1e-6;
    double x = 0, v = 0;
    for (double t = 0; t < until_s; t += step) {
      if (static_cast<double>(at_.size()) * 1e-3 <= t + step / 2) at_.push_back(x);
      const double d = way - x, knee = b / 120;
      const double curve = 120 * d <= knee ? 120 * d : std::sqrt(2 * b * d - knee * knee);
      v = std::min({v + acceleration * step, speed, curve});
      x += v * step;
    }
  }
  double at(double time_s) const {
    const double place = time_s * 1000;
    const auto i = static_cast<std::size_t>(place);
    return i + 1 < at_.size() ? at_[i] + (place - static_cast<double>(i)) * (at_[i + 1] - at_[i]) : at_.back();
  }

 private:
  std::vector<double> at_;  // every millisecond
};

TEST(LimitRates, APointTakesTheSamePathAtEveryFrameRate) {
  const float limits[][3] = {{1, 2, 10}, {1, 100, 20}, {0.01f, 3, 50}, {10, 4, 8}};  // way, speed, acceleration
  int frames = 0;
  double worst = 0;
  for (const auto& [way, speed, acceleration] : limits) {
    const Ideal ideal(way, speed, acceleration, 4);
    for (const int rate : kRates) {
      PointFollower state = {};
      const float dt = 1.0f / static_cast<float>(rate), start[3] = {}, target[3] = {0, way, 0};
      ASSERT_EQ(follow_point(state, start, dt, {speed, acceleration}), Status::ok);
      // The target goes there at once, and then is at rest.
      ASSERT_EQ(follow_point(state, target, 1e-6f, {speed, acceleration}), Status::ok);
      double before = 0, velocity = 0;
      for (int frame = 1; frame <= 4 * rate; ++frame, ++frames) {
        ASSERT_EQ(follow_point(state, target, dt, {speed, acceleration}), Status::ok);
        const double y = static_cast<double>(state.point[1]), v = static_cast<double>(state.velocity[1]);
        worst =
            std::max(worst, std::fabs(y - ideal.at(frame / static_cast<double>(rate))) / std::max<double>(way, 0.1));
        EXPECT_GE(y, before);
        EXPECT_LE(y, static_cast<double>(way));
        EXPECT_LE(v, static_cast<double>(speed) * 1.00001);
        EXPECT_LE(std::fabs(v - velocity), static_cast<double>(acceleration * dt) * 1.0001 + 1e-3);
        before = y;
        velocity = v;
      }
      EXPECT_EQ(std::memcmp(state.point, target, sizeof target), 0) << rate;
      EXPECT_EQ(state.velocity[1], 0);
    }
  }
  EXPECT_GT(frames, 20000);
  EXPECT_LT(worst, 2e-4);
}

TEST(LimitRates, ARotationTakesTheSamePathAtEveryFrameRate) {
  const Vec3 axis = {0.3, -0.5, 0.7};
  const double way = 2.9;
  const RateLimit limit = {4, 25};
  const Ideal ideal(way, 4, 25, 2);
  float target[4];
  set(target, axis_angle(axis, way));
  int frames = 0;
  double worst = 0, aside = 0;
  for (const int rate : kRates) {
    RotationFollower state = {};
    const float dt = 1.0f / static_cast<float>(rate), start[4] = {0, 0, 0, 1};
    ASSERT_EQ(follow_rotation(state, start, dt, limit), Status::ok);
    ASSERT_EQ(follow_rotation(state, target, 1e-6f, limit), Status::ok);
    for (int frame = 1; frame <= 2 * rate; ++frame, ++frames) {
      ASSERT_EQ(follow_rotation(state, target, dt, limit), Status::ok);
      const double angle = ideal.at(frame / static_cast<double>(rate));
      const double off = angle_between(matrix(quat(state.rotation)), matrix(axis_angle(axis, angle)));
      worst = std::max(worst, off);
      // Along the axis the whole way.
      const Vec3 part = {static_cast<double>(state.rotation[0]), static_cast<double>(state.rotation[1]),
                         static_cast<double>(state.rotation[2])};
      aside = std::max(aside, length(cross(part, normalised(axis))));
    }
    EXPECT_EQ(std::memcmp(state.rotation, target, sizeof target), 0) << rate;
  }
  EXPECT_GT(frames, 2000);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(aside, 1e-5);
}

// How often the velocity changes its sign, once it is there.
template <class Step>
int shakes(float rate_hz, Step step) {
  float x = 0, v = 0, last = 0;
  int count = 0;
  for (int frame = 0; frame < static_cast<int>(10 * rate_hz); ++frame) {
    step(x, v, 1 / rate_hz);
    count += v * last < 0;
    if (v != 0) last = v;
  }
  return count;
}

TEST(LimitRates, AClampAloneShakesAndThisDoesNot) {
  const float target = 1, speed = 2, acceleration = 10;
  int shaking = 0;
  for (const int rate : kRates) {
    const auto hz = static_cast<float>(rate);
    // What one writes first: the velocity that would arrive, clamped, and its change clamped.
    shaking += shakes(hz, [&](float& x, float& v, float dt) {
                 const float wanted = std::clamp((target - x) / dt, -speed, speed);
                 v += std::clamp(wanted - v, -acceleration * dt, acceleration * dt);
                 x += v * dt;
               }) > 1;
    PointFollower state = {};
    ASSERT_EQ(follow_point(state, {0, 0, 0}, 0, {speed, acceleration}), Status::ok);
    EXPECT_EQ(shakes(hz,
                     [&](float& x, float& v, float dt) {
                       ASSERT_EQ(follow_point(state, {target, 0, 0}, dt, {speed, acceleration}), Status::ok);
                       x = state.point[0];
                       v = state.velocity[0];
                     }),
              0)
        << rate;
    EXPECT_EQ(state.point[0], target);
  }
  EXPECT_GE(shaking, 15);  // of 16: at one rate its steps happen to end on the target
}

TEST(LimitRates, OnATargetWithinTheLimitsItStaysToTheBit) {
  int frames = 0;
  for (const int rate : kRates) {
    PointFollower point = {};
    RotationFollower turn = {};
    const float dt = 1 / static_cast<float>(rate);
    for (int frame = 0; frame <= 4 * rate; ++frame, ++frames) {
      // 1 - cos: from rest, with a speed of at most 1.5 and an acceleration of at most 4.5.
      const double at = 0.5 * (1 - std::cos(3 * frame / static_cast<double>(rate)));
      const float p[3] = {static_cast<float>(at), 2, static_cast<float>(-at)};
      float q[4];
      set(q, axis_angle({1, 2, 3}, at));
      ASSERT_EQ(follow_point(point, p, dt, {2.2f, 7}), Status::ok);
      ASSERT_EQ(follow_rotation(turn, q, dt, {2, 6}), Status::ok);
      EXPECT_EQ(std::memcmp(point.point, p, sizeof p), 0) << rate << " " << frame;
      EXPECT_EQ(std::memcmp(turn.rotation, q, sizeof q), 0) << rate << " " << frame;
    }
  }
  EXPECT_GT(frames, 5000);
}

// A rotation that cannot be followed: up to 6 rad/s and 40 rad/s², about an axis that wanders; within 60° of one place,
// so that the shorter way to it is always the same.
Quat wild(double t) {
  const Vec3 v = {0.6 * std::sin(5 * t), 0.6 * std::sin(7 * t + 1), 0.6 * std::sin(6 * t + 2)};
  return axis_angle(v, length(v));
}

TEST(LimitRates, AMovingTargetIsFollowedWithinTheLimits) {
  const RateLimit limit = {3, 12};
  int frames = 0;
  double fastest = 0, hardest = 0;
  for (const int rate : kRates) {
    RotationFollower state = {};
    const float dt = 1 / static_cast<float>(rate);
    Mat3 before{};
    Vec3 velocity{};
    for (int frame = 0; frame <= 10 * rate; ++frame) {
      float q[4];
      set(q, wild(frame / static_cast<double>(rate)));
      ASSERT_EQ(follow_rotation(state, q, dt, limit), Status::ok);
      const Mat3 now = matrix(quat(state.rotation));
      const Vec3 v = {static_cast<double>(state.velocity[0]), static_cast<double>(state.velocity[1]),
                      static_cast<double>(state.velocity[2])};
      if (frame > 0) {
        ++frames;
        fastest = std::max({fastest, angle_between(before, now) * rate, length(v)});
        hardest = std::max(hardest, length(minus(v, velocity)) * rate);
      }
      before = now;
      velocity = v;
    }
  }
  EXPECT_GT(frames, 10000);
  EXPECT_LT(fastest, 3.003);
  EXPECT_LT(hardest, 12 * 1.1);
}

TEST(LimitRates, AMovingTargetIsFollowedAlikeAtEveryFrameRate) {
  const RateLimit limit = {3, 12};
  const std::pair<int, double> tolerances[] = {{960, 0}, {240, 0.005}, {120, 0.02}, {60, 0.04}, {30, 0.12}, {15, 0.2}};
  std::vector<Mat3> finest;
  int compared = 0;
  for (const auto& [rate, tolerance] : tolerances) {
    RotationFollower state = {};
    double worst = 0;
    for (int frame = 0; frame <= 10 * rate; ++frame, ++compared) {
      float q[4];
      set(q, wild(frame / static_cast<double>(rate)));
      ASSERT_EQ(follow_rotation(state, q, 1 / static_cast<float>(rate), limit), Status::ok);
      const Mat3 now = matrix(quat(state.rotation));
      if (rate == 960) finest.push_back(now);
      worst = std::max(worst, angle_between(finest[static_cast<std::size_t>(frame * (960 / rate))], now));
    }
    EXPECT_LE(worst, tolerance) << rate;
  }
  EXPECT_GT(compared, 10000);
}

TEST(LimitRates, ATargetThatGoesStraightBetweenFramesIsFollowedOnOnePath) {
  // Corners every fifteenth of a second, so that at these rates all frames see the same target.
  const RateLimit limit = {1.5f, 9};
  std::vector<std::array<double, 3>> finest;
  int compared = 0;
  double worst = 0, farthest = 0;
  for (const int rate : {960, 480, 240, 120, 60, 30, 15}) {
    PointFollower state = {};
    for (int frame = 0; frame <= 10 * rate; ++frame, ++compared) {
      const int every = rate / 15, corner = frame / every;
      const double share = (frame % every) / static_cast<double>(every);
      float p[3];
      for (int i = 0; i < 3; ++i) {
        const auto at = [&](int k) { return 0.6 * std::sin((5 + i) * k / 15.0 + i); };
        p[i] = static_cast<float>(at(corner) + share * (at(corner + 1) - at(corner)));
      }
      ASSERT_EQ(follow_point(state, p, 1 / static_cast<float>(rate), limit), Status::ok);
      const std::array<double, 3> now = {static_cast<double>(state.point[0]), static_cast<double>(state.point[1]),
                                         static_cast<double>(state.point[2])};
      if (rate == 960) finest.push_back(now);
      worst = std::max(worst, length(minus(finest[static_cast<std::size_t>(frame * (960 / rate))], now)));
      farthest = std::max(farthest, length(minus(now, Vec3{p[0], p[1], p[2]})));
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(farthest, 0.1);  // it is left behind
  EXPECT_LT(worst, 2e-5);
}

TEST(LimitRates, ATeleportTakesTheTargetAsItIs) {
  PointFollower state = {};
  const float a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {50, 60, 70};
  ASSERT_EQ(follow_point(state, a, 0.1f, {1, 1}), Status::ok);
  ASSERT_EQ(follow_point(state, b, 0.1f, {1, 1}), Status::ok);
  EXPECT_LT(state.point[0], 0.1f);
  state = {};
  ASSERT_EQ(follow_point(state, c, 0, {1, 1}), Status::ok);
  EXPECT_EQ(std::memcmp(state.point, c, sizeof c), 0);
  EXPECT_EQ(state.velocity[0], 0);
}

TEST(LimitRates, NoTimeChangesNothingAndMuchIsSafe) {
  RotationFollower state = {};
  const float a[4] = {0, 0, 0, 1}, b[4] = {1, 0, 0, 0}, limit_speed = 5;
  ASSERT_EQ(follow_rotation(state, a, 0.1f, {limit_speed, 30}), Status::ok);
  ASSERT_EQ(follow_rotation(state, b, 0.1f, {limit_speed, 30}), Status::ok);
  const RotationFollower before = state;
  ASSERT_EQ(follow_rotation(state, b, 0, {limit_speed, 30}), Status::ok);
  EXPECT_EQ(std::memcmp(&state, &before, sizeof state), 0);
  for (const float dt : {1e-30f, 1e-6f, 0.25f, 1.0f, 1e6f, 1e38f}) {
    for (const RateLimit limit : {RateLimit{0, 0}, RateLimit{5, 0}, RateLimit{0, 30}, RateLimit{1e-6f, 1e-6f},
                                  RateLimit{1e17f, 1e17f}, RateLimit{5, 30}}) {
      state = before;
      for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(follow_rotation(state, i % 3 == 0 ? a : b, dt, limit), Status::ok);
        double squared = 0;
        for (const float x : state.rotation) squared += static_cast<double>(x) * static_cast<double>(x);
        EXPECT_NEAR(squared, 1, 1e-5);
        for (const float x : state.velocity) EXPECT_TRUE(std::isfinite(x));
      }
    }
  }
}

TEST(LimitRates, WithoutALimitOfAccelerationItGoesWithTheSpeed) {
  for (const int rate : kRates) {
    PointFollower state = {};
    const float dt = 1 / static_cast<float>(rate), a[3] = {0, 0, 0}, b[3] = {0, 0, 3};
    ASSERT_EQ(follow_point(state, a, dt, {2, 0}), Status::ok);
    for (int frame = 1; frame <= 2 * rate; ++frame) {
      ASSERT_EQ(follow_point(state, b, dt, {2, 0}), Status::ok);
      EXPECT_NEAR(state.point[2], std::fmin(3, 2.0 * frame / rate), 1e-4) << rate;
    }
    EXPECT_EQ(state.point[2], 3);
  }
}

TEST(LimitRates, RefuseBadCalls) {
  const float good[4] = {0, 0, 0, 1}, bad[4] = {0, kNotANumber, 0, 1}, none[4] = {};
  const float infinite = std::numeric_limits<float>::infinity();
  RotationFollower turn = {};
  PointFollower point = {};
  ASSERT_EQ(follow_rotation(turn, good, 0, {1, 1}), Status::ok);
  const RotationFollower before = turn;
  EXPECT_EQ(follow_rotation(turn, bad, 0.1f, {1, 1}), Status::bad_argument);
  EXPECT_EQ(follow_rotation(turn, none, 0.1f, {1, 1}), Status::bad_argument);
  for (const float x : {-1.0f, kNotANumber, infinite}) {
    EXPECT_EQ(follow_rotation(turn, good, x, {1, 1}), Status::bad_argument);
    EXPECT_EQ(follow_rotation(turn, good, 0.1f, {x, 1}), Status::bad_argument);
    EXPECT_EQ(follow_rotation(turn, good, 0.1f, {1, x}), Status::bad_argument);
    EXPECT_EQ(follow_point(point, {0, 0, 0}, x, {1, 1}), Status::bad_argument);
    EXPECT_EQ(follow_point(point, {0, 0, 0}, 0.1f, {1, x}), Status::bad_argument);
  }
  EXPECT_EQ(follow_point(point, {0, infinite, 0}, 0.1f, {1, 1}), Status::bad_argument);
  EXPECT_EQ(std::memcmp(&turn, &before, sizeof turn), 0);
  EXPECT_EQ(point.mode, 0u);
}

// Far targets, hardly any time, rates of any size: nothing that a follower keeps is ever not finite.
TEST(LimitRates, StayFiniteOnAnything) {
  test::Random random(38);
  const float times_s[] = {1e-45f, 1e-38f, 1e-20f, 1e-6f, 1.0f / 60, 1e30f};
  const float sizes[] = {0.0f, 1e-45f, 1e-20f, 1.0f, 1e9f, 5e14f};
  const float rates[] = {0.0f, 1e-45f, 1e-9f, 1.0f, 1e9f, 9e17f};
  const auto any = [&](const float(&from)[6]) { return from[random.below(6)]; };
  const auto all_finite = [](const auto& numbers) {
    for (const float x : numbers)
      if (!std::isfinite(x)) return false;
    return true;
  };
  for (int run = 0; run < 500; ++run) {
    PointFollower point;
    RotationFollower turn;
    for (int frame = 0; frame < 30; ++frame) {
      const float dt_s = any(times_s);
      const RateLimit limit = {any(rates), any(rates)};
      const float target[3] = {any(sizes), -any(sizes), any(sizes)};
      ASSERT_EQ(follow_point(point, target, dt_s, limit), Status::ok);
      ASSERT_TRUE(all_finite(point.point) && all_finite(point.velocity)) << run << ' ' << frame;
      float to[4];
      const test::Quat q = random.rotation();
      for (std::size_t i = 0; i < 4; ++i) to[i] = static_cast<float>(q[i]);
      ASSERT_EQ(follow_rotation(turn, to, dt_s, limit), Status::ok);
      ASSERT_TRUE(all_finite(turn.rotation) && all_finite(turn.velocity)) << run << ' ' << frame;
    }
  }
}

TEST(LimitRates, OfAPoseTurnTheirJointsAlone) {
  std::array<SoaTransform, 2> pose = {};
  const auto turn_all = [&](double angle) {
    const Quat q = axis_angle({0, 1, 0}, angle);
    for (SoaTransform& group : pose)
      for (std::size_t c = 0; c < 4; ++c)
        for (float& lane : group.rotation[c]) lane = static_cast<float>(q[c]);
  };
  std::array<JointLimit, 3> limits = {};
  LimitDescription d;
  ASSERT_EQ(make_limit(d, 1, limits[0]), Status::ok);  // no rate
  d.rate = {1, 0};
  ASSERT_EQ(make_limit(d, 3, limits[1]), Status::ok);
  d.rate = {2, 0};
  ASSERT_EQ(make_limit(d, 6, limits[2]), Status::ok);
  std::array<RotationFollower, 3> states = {};
  turn_all(0);
  ASSERT_EQ(follow_pose(limits, states, 0.1f, pose), Status::ok);
  turn_all(2);
  ASSERT_EQ(follow_pose(limits, states, 0.1f, pose), Status::ok);
  for (std::size_t joint = 0; joint < 8; ++joint) {
    const double angle = 2 * std::asin(static_cast<double>(pose[joint / 4].rotation[1][joint % 4]));
    EXPECT_NEAR(angle, joint == 3 ? 0.1 : joint == 6 ? 0.2 : 2, 1e-5) << joint;
  }
  EXPECT_EQ(follow_pose(limits, Span<RotationFollower>(states.data(), 2), 0.1f, pose), Status::bad_argument);
  EXPECT_EQ(follow_pose(limits, states, -1, pose), Status::bad_argument);
  EXPECT_EQ(follow_pose(limits, states, 0.1f, Span<SoaTransform>(pose.data(), 1)), Status::bad_argument);
}

TEST(LimitRates, AFrameAllocatesNothing) {
  LimitRandom random(7);
  std::array<SoaTransform, 8> pose = {};
  std::vector<JointLimit> limits(32);
  std::vector<RotationFollower> followers(limits.size());
  for (std::size_t j = 0; j < limits.size(); ++j) {
    LimitDescription d = any_limit(random, kAllKinds[j % 3]);
    d.rate = {2, 10};
    ASSERT_EQ(make_limit(d, static_cast<std::uint16_t>(j), limits[j]), Status::ok);
    const Quat q = any_rotation(random);
    for (std::size_t c = 0; c < 4; ++c) pose[j / 4].rotation[c][j % 4] = static_cast<float>(q[c]);
  }
  const std::size_t before = allocation_count();
  int failures = 0;
  for (int frame = 0; frame < 100; ++frame) {
    failures += limit_pose(limits, pose) != Status::ok;
    failures += follow_pose(limits, followers, 1.0f / 60, pose) != Status::ok;
  }
  EXPECT_EQ(allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

// Limits and what follows of rotations made without a library's trigonometry: one hash for every processor.
TEST(LimitRates, AreTheSameBitsEverywhere) {
  std::uint32_t noise = 0x12345678;
  const auto next = [&noise] {  // xorshift32 (Marsaglia 2003), -1 … 1
    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;
    return static_cast<float>(noise >> 8) * 0x1p-23f - 1.0f;
  };
  std::uint64_t hash = 0xCBF29CE484222325;
  const auto take = [&hash](const void* data, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001B3;
  };
  int taken = 0;
  RotationFollower follower = {};
  for (int i = 0; i < 6000; ++i, ++taken) {
    LimitDescription d;
    d.kind = kAllKinds[i % 3];
    d.order = static_cast<AxisOrder>(i / 3 % 6);
    for (float& x : d.zero) x = next();
    for (float& x : d.axis) x = next();
    for (int k = 0; k < 3; ++k) {
      d.most_rad[k] = 0.7f + 0.6f * next();
      d.least_rad[k] = -d.most_rad[k];
    }
    JointLimit limit = {};
    if (make_limit(d, 0, limit) != Status::ok) continue;
    take(&limit, sizeof limit);
    float q[4] = {next(), next(), next(), next()};
    ASSERT_EQ(clamp_rotation(limit, q), Status::ok);
    take(q, sizeof q);
    const float excess = limit_excess(limit, follower.rotation);
    take(&excess, sizeof excess);
    ASSERT_EQ(follow_rotation(follower, q, 0.02f + 0.01f * next(), {3, 20}), Status::ok);
    take(&follower, sizeof follower);
  }
  EXPECT_EQ(taken, 6000);
  EXPECT_EQ(hash, 0xFC5C226C217CD794u) << std::hex << hash;
}

}  // namespace
}  // namespace marrow
