// advance: against a walk in whole units, exact sums in integers, and arithmetic done by hand.
#include "marrow/playback.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::kInfinity;

constexpr float kLargest = std::numeric_limits<float>::max();

Playback at(double time_s, PlayMode mode, float speed = 1, bool returning = false) {
  Playback p;
  p.time_s = time_s;
  p.mode = mode;
  p.speed = speed;
  p.returning = returning;
  return p;
}

// One step in a clip of 2 s.
Playback step(Playback p, float dt_s) {
  EXPECT_EQ(advance(p, 2.0f, dt_s), Status::ok);
  return p;
}

void expect_at(const Playback& p, double time_s, int turns, bool returning = false) {
  EXPECT_EQ(p.time_s, time_s);
  EXPECT_EQ(p.turns, turns);
  EXPECT_EQ(p.returning, returning);
  EXPECT_EQ(clip_time(p), static_cast<float>(time_s));
}

TEST(Playback, OnceStopsAtTheEnds) {
  expect_at(step(at(0.5, PlayMode::once), 0.25f), 0.75, 0);
  expect_at(step(at(0.5, PlayMode::once), 1.5f), 2, 0);
  expect_at(step(at(0.5, PlayMode::once), 1e30f), 2, 0);
  expect_at(step(at(0.5, PlayMode::once, -2), 0.125f), 0.25, 0);
  expect_at(step(at(0.5, PlayMode::once, -2), 9), 0, 0);
  expect_at(step(at(0.5, PlayMode::once), -9), 0, 0);
  expect_at(step(at(0.5, PlayMode::once, 0), 9), 0.5, 0);
  expect_at(step(at(7, PlayMode::once), 0), 2, 0);
}

TEST(Playback, OnceIsFinishedAtTheEndThatItRunsTo) {
  EXPECT_TRUE(finished(at(2, PlayMode::once), 2));
  EXPECT_FALSE(finished(at(1.9, PlayMode::once), 2));
  EXPECT_FALSE(finished(at(2, PlayMode::once, -1), 2));
  EXPECT_TRUE(finished(at(0, PlayMode::once, -1), 2));
  EXPECT_FALSE(finished(at(0, PlayMode::once), 2));
  EXPECT_FALSE(finished(at(2, PlayMode::once, 0), 2));
  EXPECT_TRUE(finished(at(0, PlayMode::once), 0));
  EXPECT_FALSE(finished(at(2, PlayMode::loop), 2));
  EXPECT_FALSE(finished(at(2, PlayMode::ping_pong), 2));
}

TEST(Playback, LoopWraps) {
  expect_at(step(at(1.5, PlayMode::loop), 0.25f), 1.75, 0);
  expect_at(step(at(1.5, PlayMode::loop), 0.5f), 0, 1);
  expect_at(step(at(1.5, PlayMode::loop), 0.75f), 0.25, 1);
  expect_at(step(at(1.5, PlayMode::loop), 100.75f), 0.25, 51);
  expect_at(step(at(0.5, PlayMode::loop, -1), 0.5f), 0, 0);
  expect_at(step(at(0.0, PlayMode::loop, -1), 0.5f), 1.5, -1);
  expect_at(step(at(0.5, PlayMode::loop, -1), 2.5f), 0, -1);
  expect_at(step(at(0.5, PlayMode::loop, -4), 1), 0.5, -2);
  expect_at(step(at(5.5, PlayMode::loop), 0), 1.5, 2);
}

TEST(Playback, PingPongTurns) {
  expect_at(step(at(1.5, PlayMode::ping_pong), 0.5f), 2, 0);
  expect_at(step(at(2.0, PlayMode::ping_pong), 0.5f), 1.5, 1, true);
  expect_at(step(at(1.5, PlayMode::ping_pong, 1, true), 0.5f), 1, 0, true);
  expect_at(step(at(0.5, PlayMode::ping_pong, 1, true), 0.5f), 0, 0, true);
  expect_at(step(at(0.5, PlayMode::ping_pong, 1, true), 0.75f), 0.25, 1);
  expect_at(step(at(0.5, PlayMode::ping_pong, -1), 0.75f), 0.25, 1, true);
  expect_at(step(at(0.5, PlayMode::ping_pong), 4), 0.5, 2);
  expect_at(step(at(0.5, PlayMode::ping_pong), 3.5f), 0, 1, true);
  expect_at(step(at(0.5, PlayMode::ping_pong), 5.75f), 1.75, 3, true);
}

// What advance() says, one unit of time after the other.
struct Walk {
  int duration, at, turns = 0;
  bool returning = false;

  void loop(int units) {
    for (turns = 0; units > 0; --units)
      if (++at == duration) at = 0, ++turns;
    for (; units < 0; ++units) {
      if (at == 0) at = duration, --turns;
      --at;
    }
  }
  void ping_pong(int units) {
    int direction = (units < 0) != returning ? -1 : 1;
    turns = 0;
    for (int left = std::abs(units); left > 0; --left, at += direction) {
      if (at + direction >= 0 && at + direction <= duration) continue;
      direction = -direction;
      returning = !returning;
      ++turns;
    }
  }
};

TEST(Playback, ManyStepsAreThoseOfAWalkInUnits) {
  test::Random random(71);
  constexpr double kUnit = 1.0 / 128;
  int steps = 0, turned = 0;
  for (int run = 0; run < 400; ++run) {
    Walk walk{1 + static_cast<int>(random.below(run % 2 == 0 ? 8 : 300)), 0};
    const bool loop = run % 4 < 2;
    Playback p = at(0, loop ? PlayMode::loop : PlayMode::ping_pong);
    const auto duration_s = static_cast<float>(walk.duration * kUnit);
    for (int i = 0; i < 100; ++i, ++steps) {
      const int units = static_cast<int>(random.below(401)) - 200, speed = 1 << random.below(3);
      p.speed = static_cast<float>(speed);
      ASSERT_EQ(advance(p, duration_s, static_cast<float>(units * kUnit)), Status::ok);
      loop ? walk.loop(units * speed) : walk.ping_pong(units * speed);
      ASSERT_EQ(p.time_s, walk.at * kUnit);
      ASSERT_EQ(p.turns, walk.turns);
      ASSERT_EQ(p.returning, walk.returning);
      turned += p.turns != 0;
    }
  }
  EXPECT_EQ(steps, 40000);
  EXPECT_GT(turned, 20000);
}

// Ten million frames of 1/60 s at an odd speed, summed exactly in units of 2⁻⁵³ s: floats that small are whole numbers.
void expect_no_drift(float speed) {
  const double unit = std::ldexp(1.0, -53);
  const float dt_s = 1.0f / 60, duration_s = 9.7f;
  const double move = static_cast<double>(dt_s) * static_cast<double>(speed) / unit;
  ASSERT_EQ(move, std::floor(move)) << "or the reference is not exact";
  const auto moved = static_cast<std::int64_t>(move);
  const auto period = static_cast<std::int64_t>(static_cast<double>(duration_s) / unit);
  std::int64_t exact = 0, turns = 0, exact_turns = 0;
  Playback p = at(0, PlayMode::loop, speed);
  for (int i = 0; i < 10'000'000; ++i) {
    exact += moved;
    if (exact >= period) exact -= period, ++exact_turns;
    if (exact < 0) exact += period, --exact_turns;
    if (advance(p, duration_s, dt_s) != Status::ok) FAIL();
    turns += p.turns;
  }
  EXPECT_EQ(turns, exact_turns);
  const double stated_s = unit * (1e7 * (9.7 + 1.0 / 60) + std::fabs(static_cast<double>(turns)) * 9.7);
  EXPECT_LT(stated_s, 2e-8);
  EXPECT_NEAR(p.time_s, static_cast<double>(exact) * unit, stated_s);
}

TEST(Playback, TenMillionStepsForward) {
  expect_no_drift(0.7f);
}

TEST(Playback, TenMillionStepsBackward) {
  expect_no_drift(-0.7f);
}

// fmod is exact, so this is too, however many turns there are.
TEST(Playback, AnyNumberOfTurnsInOneStep) {
  int cases = 0;
  for (const float duration_s : {std::numeric_limits<float>::denorm_min(), 1e-30f, 0.3f, 1.0f, 77.7f, kLargest}) {
    for (const float dt_s : {1e-40f, 1e-3f, 5.3f, 1e9f, kLargest}) {
      for (const float speed : {1.0f, 0.37f, kLargest}) {
        const double moved = static_cast<double>(dt_s) * static_cast<double>(speed);
        const double duration = static_cast<double>(duration_s);
        Playback p = at(0, PlayMode::loop, speed);
        ASSERT_EQ(advance(p, duration_s, dt_s), Status::ok);
        EXPECT_EQ(p.time_s, std::fmod(moved, duration));
        EXPECT_EQ(p.turns, std::fmin(std::floor(moved / duration), 2147483647.0));
        p = at(0, PlayMode::ping_pong, speed);
        ASSERT_EQ(advance(p, duration_s, dt_s), Status::ok);
        const double phase = std::fmod(moved, 2 * duration);
        EXPECT_EQ(p.time_s, phase > duration ? 2 * duration - phase : phase);
        EXPECT_EQ(p.returning, phase > duration || (phase == 0 && moved > 0)) << "turns when it moves on";
        p = at(0, PlayMode::loop, -speed);
        ASSERT_EQ(advance(p, duration_s, dt_s), Status::ok);
        EXPECT_GE(p.time_s, 0);
        EXPECT_LT(p.time_s, duration);
        EXPECT_LE(clip_time(p), duration_s);
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 90);
}

TEST(Playback, TinyStepsBackOverTheStartStayInTheClip) {
  Playback p = at(0, PlayMode::loop, -1);
  ASSERT_EQ(advance(p, 2, 1e-30f), Status::ok);
  EXPECT_EQ(p.turns, -1);
  EXPECT_LT(p.time_s, 2);
  EXPECT_GT(p.time_s, 2 - 1e-15);
  ASSERT_EQ(advance(p, 2, 1e-30f), Status::ok);
  EXPECT_EQ(p.turns, 0) << "the start was passed once";
}

TEST(Playback, AClipWithoutLength) {
  int cases = 0;
  for (const PlayMode mode : {PlayMode::once, PlayMode::loop, PlayMode::ping_pong}) {
    for (const float dt_s : {-1.0f, 0.0f, 1e30f}) {
      Playback p = at(3, mode);
      p.turns = 9;
      ASSERT_EQ(advance(p, 0, dt_s), Status::ok);
      expect_at(p, 0, 0);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 9);
}

TEST(Playback, WhatIsNotFiniteIsRefusedAndChangesNothing) {
  int refused = 0;
  for (const PlayMode mode : {PlayMode::once, PlayMode::loop, PlayMode::ping_pong}) {
    for (const float bad : {kInfinity, -kInfinity, std::nanf("")}) {
      for (int which = 0; which < 4; ++which) {
        Playback p = at(which == 0 ? static_cast<double>(bad) : 1.0, mode, which == 1 ? bad : 1.0f);
        p.turns = 9;
        refused += advance(p, which == 2 ? bad : 2.0f, which == 3 ? bad : 0.5f) == Status::bad_argument;
        EXPECT_EQ(p.turns, 9);
        EXPECT_TRUE(which == 0 || p.time_s == 1);
      }
    }
    Playback p = at(1, mode);
    refused += advance(p, -1.0f, 0.5f) == Status::bad_argument;
  }
  EXPECT_EQ(refused, 3 * (3 * 4 + 1));
}

// A clip whose last pose is its first: from one frame to the next it moves by no more than its speed allows, also over
// the seam, and after a whole number of rounds it is where it was.
TEST(Playback, ALoopIsSeamless) {
  test::TestClip clip;
  clip.add(0, TrackPath::translation, Interpolation::linear, {0, 0.5f, 1}, {0, 0, 0, 1, 0, 0, 0, 0, 0});
  const test::TestSkeleton skeleton(std::vector<test::TestJoint>(1));
  std::vector<SoaTransform> pose(1);
  Playback p = at(0, PlayMode::loop);
  float last = 0;
  int rounds = 0;
  for (int frame = 1; frame <= 640; ++frame) {
    ASSERT_EQ(advance(p, clip.duration_s, 5.0f / 64), Status::ok);
    ASSERT_EQ(sample(skeleton.view(), clip.view(), clip_time(p), pose), Status::ok);
    const float x = pose[0].translation[0][0];
    EXPECT_LE(std::fabs(x - last), 2 * 5.0f / 64) << frame;
    last = x;
    rounds += p.turns;
  }
  EXPECT_EQ(rounds, 50);
  EXPECT_EQ(last, 0);
}

}  // namespace
}  // namespace marrow
