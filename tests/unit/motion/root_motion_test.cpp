// Root motion: against matrices in double, walked round by round, and integration in small steps.
#include "marrow/root_motion.h"

#include <cstdio>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/call_errors.h"
#include "support/rig.h"
#include "unit/motion/any_bits.h"
#include "unit/motion/rigid_reference.h"

namespace marrow {
namespace {

using test::back;
using test::distance;
using test::Frame;
using test::frame_of;
using test::Random;
using test::Real;
using test::screw_frame;
using test::turned_apart;
using test::wide;

// A walk that turns: a rotation about some axis and a way, a bit further at each key.
std::vector<RootKey> some_keys(Random& random, float duration_s) {
  std::vector<RootKey> out = {{0, {0, 0, 0, 1}, {0, 0, 0}}};
  const std::uint32_t count = 1 + random.below(6);
  for (std::uint32_t i = 1; i <= count; ++i) {
    const auto turn = random.rotation();
    // Less than half a turn from key to key.
    const double w = std::fabs(turn[3]) + 1, length = std::sqrt(1 - turn[3] * turn[3] + w * w);
    RootKey k{duration_s * (static_cast<float>(i) / static_cast<float>(count)), {}, {}};
    for (std::size_t c = 0; c < 4; ++c) k.rotation[c] = static_cast<float>((c < 3 ? turn[c] : w) / length);
    if (random.below(2) == 0)
      for (float& q : k.rotation) q = -q;  // the same rotation
    for (int c = 0; c < 3; ++c) k.translation[c] = static_cast<float>(random.between(-1, 1));
    out.push_back(k);
  }
  return out;
}

// M(t), from the words of the header.
Frame reference_root(const std::vector<RootKey>& keys, Real time_s) {
  std::size_t i = 0;
  while (i + 2 < keys.size() && wide(keys[i + 1].time_s) <= time_s) ++i;
  const RootKey &a = keys[i], &b = keys[i + 1];
  const Real share = (time_s - wide(a.time_s)) / (wide(b.time_s) - wide(a.time_s));
  const Real u = std::fmin(std::fmax(share, Real{0}), Real{1});
  Real dot = 0, q[4], t[3];
  for (int c = 0; c < 4; ++c) dot += wide(a.rotation[c]) * wide(b.rotation[c]);
  for (int c = 0; c < 4; ++c) q[c] = (1 - u) * wide(a.rotation[c]) + (dot < 0 ? -u : u) * wide(b.rotation[c]);
  for (int c = 0; c < 3; ++c) t[c] = (1 - u) * wide(a.translation[c]) + u * wide(b.translation[c]);
  return frame_of(q[0], q[1], q[2], q[3], t[0], t[1], t[2]);
}

RigidStep step_of(const ClipMotion& motion, const Playback& before, const Playback& after) {
  RigidStep out;
  EXPECT_EQ(root_step(motion, before, after, out), Status::ok);
  return out;
}

TEST(RootMotion, IsSampledAsTheHeaderSays) {
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const float duration_s = static_cast<float>(random.between(0.5, 3));
    const std::vector<RootKey> keys = some_keys(random, duration_s);
    const ClipMotion motion{.duration_s = duration_s, .root = keys};
    ASSERT_TRUE(is_valid(motion));
    const float time_s = static_cast<float>(random.between(-0.5, 1.5)) * duration_s;
    RigidStep at;
    ASSERT_EQ(sample_root(motion, time_s, at), Status::ok);
    const Frame want = reference_root(keys, wide(time_s));
    ASSERT_LT(distance(frame_of(at), want), 3e-7);
    ASSERT_LT(turned_apart(frame_of(at), want), 5e-7);
    ASSERT_GE(at.rotation[3], 0);
  }
}

TEST(RootMotion, OfManyRoundsIsThatOfOneManyTimes) {
  Random random(4);
  Real worst = 0;
  int compared = 0;
  for (int clip = 0; clip < 4; ++clip) {
    std::vector<RootKey> keys = some_keys(random, 1);
    if (clip == 0) keys = {{0, {0, 0, 0, 1}, {}}, {1, {0, 0, 0, 1}, {0.1f, 0, 1.3f}}};      // straight
    if (clip == 1) keys = {{0, {0, 0, 0, 1}, {}}, {1, {0, 1e-6f, 0, 1}, {0.1f, 0, 1.3f}}};  // a huge circle
    const ClipMotion motion{.duration_s = 1, .root = keys};
    const Frame once = reference_root(keys, 1), inverse = back(once);
    const Real length =
        std::sqrt(once.place[0] * once.place[0] + once.place[1] * once.place[1] + once.place[2] * once.place[2]);
    const Frame from = reference_root(keys, 0.25), to = reference_root(keys, 0.625);
    Frame forward, backward;
    int next = 1;
    for (int n = 1; n <= 1000000; ++n) {
      forward = forward * once, backward = backward * inverse;
      if (n < next) continue;
      next = n * 3 < 1000000 ? n * 3 : 1000000;
      const Frame ahead = back(from) * forward * to, behind = back(from) * backward * to;
      const Real most = 1e-6 + std::ldexp(length * n, -24);
      const Real one = distance(frame_of(step_of(motion, {.time_s = 0.25}, {.time_s = 0.625, .turns = n})), ahead);
      const Real two = distance(
          frame_of(step_of(motion, {.time_s = 0.25, .speed = -1}, {.time_s = 0.625, .speed = -1, .turns = -n})),
          behind);
      EXPECT_LT(one, most) << "clip " << clip << ", " << n << " rounds";
      EXPECT_LT(two, most) << "clip " << clip << ", -" << n << " rounds";
      worst = std::fmax(worst, std::fmax(one, two) / most);
      compared += 2;
      if (n == 1000000) break;
    }
  }
  EXPECT_EQ(compared, 4 * 2 * 14);
  std::printf("at most %.3f of what is allowed\n", worst);
}

// However a path is cut into steps, they come to its end: along the line that the mode makes of time.
TEST(RootMotion, OfAnyCutsIsTheSame) {
  Random random(5);
  int turned = 0;
  for (int round = 0; round < 3000; ++round) {
    const float duration_s = static_cast<float>(random.between(0.5, 2));
    const std::vector<RootKey> keys = some_keys(random, duration_s);
    const ClipMotion motion{.duration_s = duration_s, .root = keys};
    Playback p;
    p.mode = static_cast<PlayMode>(random.below(3));
    p.speed = static_cast<float>(random.between(-2, 2));
    p.time_s = random.between(0, 1) * static_cast<double>(duration_s) * 0.99;
    const Playback begin = p;
    Frame walked;
    Real rounds = 0;
    for (int step = 0; step < 12; ++step) {
      const Playback before = p;
      ASSERT_EQ(advance(p, duration_s, static_cast<float>(random.between(0, 1))), Status::ok);
      walked = walked * frame_of(step_of(motion, before, p));
      if (p.mode == PlayMode::loop) rounds += p.turns;
      turned += p.turns != 0;
    }
    const Frame once = reference_root(keys, wide(duration_s));
    Frame all = back(reference_root(keys, begin.time_s));
    for (Real i = 0; i < std::fabs(rounds); ++i) all = all * (rounds > 0 ? once : back(once));
    all = all * reference_root(keys, p.time_s);
    ASSERT_LT(distance(walked, all), 2e-5) << "round " << round;
    ASSERT_LT(turned_apart(walked, all), 1e-5) << "round " << round;
  }
  EXPECT_GT(turned, 5000);
}

TEST(RootMotion, OfTheWayBackIsTheWayTakenBack) {
  const std::vector<RootKey> keys = {{0, {0, 0, 0, 1}, {}}, {1, {0, 0, 0, 1}, {0, 0, 2}}};
  const ClipMotion motion{.duration_s = 1, .root = keys};
  const auto way = [&](Playback p, float dt_s) {
    const Playback before = p;
    EXPECT_EQ(advance(p, 1, dt_s), Status::ok);
    return step_of(motion, before, p).translation[2];
  };
  EXPECT_EQ(way({.time_s = 0.25}, 0.5f), 1);
  EXPECT_EQ(way({.time_s = 0.25}, 10.5f), 21);
  EXPECT_EQ(way({.time_s = 0.25, .speed = -2}, 0.25f), -1);
  EXPECT_EQ(way({.time_s = 1}, 0.5f), 1);  // the end of a loop is its start
  EXPECT_EQ(way({.time_s = 0.25, .mode = PlayMode::ping_pong}, 1), 1);
  EXPECT_EQ(way({.time_s = 0.25, .mode = PlayMode::ping_pong}, 1001), 1);
  EXPECT_EQ(way({.time_s = 0.25, .mode = PlayMode::ping_pong}, 1.5f), 0);
  EXPECT_EQ(way({.time_s = 0.25, .mode = PlayMode::once}, 9), 1.5f);
  EXPECT_EQ(way({.time_s = 0.25, .speed = -1, .mode = PlayMode::once}, 9), -0.5f);
  const ClipMotion still{.duration_s = 1};
  EXPECT_EQ(step_of(still, {}, {.time_s = 0.5, .turns = 3}).translation[2], 0);
}

// Keys of an even walk along an arc, exact where they stand.
std::vector<RootKey> arc(Real speed, Real turn_rate, int keys_a_second, int seconds) {
  std::vector<RootKey> out;
  for (int i = 0; i <= keys_a_second * seconds; ++i) {
    const Real t = static_cast<Real>(i) / keys_a_second, a = turn_rate * t;
    const Real forward = turn_rate == 0 ? speed * t : speed / turn_rate * std::sin(a);
    const Real aside = turn_rate == 0 ? 0 : speed / turn_rate * (1 - std::cos(a));
    out.push_back({static_cast<float>(t),
                   {0, static_cast<float>(std::sin(a / 2)), 0, static_cast<float>(std::cos(a / 2))},
                   {static_cast<float>(aside), 0, static_cast<float>(forward)}});
  }
  return out;
}

TEST(RootMotion, BlendsToTheSameWayAtAnyFrameRate) {
  const std::vector<RootKey> straight = arc(1, 0, 64, 2), turn = arc(1.5, 1.2, 64, 2);
  const ClipMotion motions[2] = {{.duration_s = 2, .root = straight}, {.duration_s = 2, .root = turn}};
  // By integration at 960 Hz, in the middle of each step: the mean of the speeds and of the rates of turning.
  Frame want;
  for (int i = 0; i < 960 * 60; ++i) {
    const Real a = 0.6 / 960, forward = 1.25 / 960;
    const Real way[3] = {0, 0, forward}, half[3] = {0, a / 2, 0}, none[3] = {};
    want = want * screw_frame(half, none) * screw_frame(none, way) * screw_frame(half, none);
  }
  for (const int rate : {240, 144, 64, 60, 32, 30, 15, 8, 4, 2, 1}) {
    Playback p[2];
    Frame at;
    for (int frame = 0; frame < rate * 60; ++frame) {
      RigidStep steps[2], blended;
      for (int c = 0; c < 2; ++c) {
        const Playback before = p[c];
        ASSERT_EQ(advance(p[c], 2, static_cast<float>(1.0 / rate)), Status::ok);
        steps[c] = step_of(motions[c], before, p[c]);
      }
      const float weights[2] = {0.5f, 0.5f};
      ASSERT_EQ(blend_root_steps(steps, weights, blended), Status::ok);
      at = at * frame_of(blended);
    }
    EXPECT_LT(distance(at, want), 1e-4) << "at " << rate << " Hz";
    EXPECT_LT(turned_apart(at, want), 1e-4) << "at " << rate << " Hz";
    std::printf("%3d Hz: %.4f mm off after 60 s\n", rate, 1000 * distance(at, want));
  }
}

RigidStep rounded(const Frame& f, const Real (&turn)[3]) {
  const Real angle = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  const Real share = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  RigidStep out;
  for (int i = 0; i < 3; ++i) {
    out.rotation[i] = static_cast<float>(turn[i] * share);
    out.translation[i] = static_cast<float>(f.place[i]);
  }
  out.rotation[3] = static_cast<float>(std::cos(angle / 2));
  return out;
}

// Steps of up to three screws whose logarithms are known, as they are what the steps are made of.
TEST(RootMotion, BlendsAreExponentialsOfMeanLogarithms) {
  Random random(6);
  int compared = 0, small = 0;
  for (int round = 0; round < 5000; ++round) {
    RigidStep steps[3], blended;
    float weights[3];
    Real turn[3] = {}, way[3] = {}, whole = 0;
    const Real size = std::pow(Real{10}, random.between(-12, 0.5));
    for (int s = 0; s < 3; ++s) {
      Real t[3], w[3], squared = 0;
      for (int i = 0; i < 3; ++i) {
        t[i] = random.between(-1, 1) * size, w[i] = random.between(-1, 1);
        squared += t[i] * t[i];
      }
      const Real most = 3.1, shrink = squared > most * most ? most / std::sqrt(squared) : 1;
      for (Real& x : t) x *= shrink;
      steps[s] = rounded(screw_frame(t, w), t);
      if (random.below(2) == 0)
        for (float& q : steps[s].rotation) q = -q;  // the same rotation
      weights[s] = random.below(4) == 0 ? 0 : static_cast<float>(random.between(0.125, 4));
      for (int i = 0; i < 3; ++i) turn[i] += wide(weights[s]) * t[i], way[i] += wide(weights[s]) * w[i];
      whole += wide(weights[s]);
    }
    ASSERT_EQ(blend_root_steps(steps, weights, blended), Status::ok);
    for (int i = 0; i < 3 && whole > 0; ++i) turn[i] /= whole, way[i] /= whole;
    const Frame want = screw_frame(turn, way);
    // A screw near half a turn has 1 / cos of it of the float's rounding.
    ASSERT_LT(distance(frame_of(blended), want), 4e-6) << "round " << round;
    ASSERT_LT(turned_apart(frame_of(blended), want), 4e-6) << "round " << round;
    ASSERT_GE(blended.rotation[3], 0);
    compared += whole > 0, small += size < 1e-6;
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(small, 1500);
}

TEST(RootMotion, BlendsOfOneAndOfNone) {
  RigidStep step{{0.6f, 0, 0, 0.8f}, {1, 2, 3}}, out;
  const float one[1] = {0.3f}, none[1] = {0};
  ASSERT_EQ(blend_root_steps({&step, 1}, one, out), Status::ok);
  EXPECT_LT(distance(frame_of(out), frame_of(step)), 3e-7);
  EXPECT_LT(turned_apart(frame_of(out), frame_of(step)), 3e-7);
  ASSERT_EQ(blend_root_steps({&step, 1}, none, out), Status::ok);
  EXPECT_EQ(out.rotation[3], 1);
  EXPECT_EQ(out.translation[0], 0);
  ASSERT_EQ(blend_root_steps({}, {}, out), Status::ok);
  EXPECT_EQ(out.rotation[3], 1);
  // Half a turn, and none at all.
  step.rotation[0] = 1, step.rotation[3] = 0;
  ASSERT_EQ(blend_root_steps({&step, 1}, one, out), Status::ok);
  EXPECT_LT(turned_apart(frame_of(out), frame_of(step)), 3e-7);
  step = {};
  ASSERT_EQ(blend_root_steps({&step, 1}, one, out), Status::ok);
  EXPECT_EQ(std::memcmp(&out, &step, sizeof out), 0);
}

TEST(RootMotion, MovesACharacterInItsOwnAxes) {
  const Affine world{{{0, 0, 2, 10}, {0, 2, 0, 20}, {-2, 0, 0, 30}}};  // a quarter turn about y, twice as large
  const RigidStep step{{0, 1, 0, 0}, {1, 2, 3}};                       // half a turn about y
  const Affine moved = move_root(world, step);
  const Affine want{{{0, 0, -2, 16}, {0, 2, 0, 24}, {2, 0, 0, 28}}};
  for (int row = 0; row < 3; ++row)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(moved.rows[row][c], want.rows[row][c]) << row << ' ' << c;
  // Axes stay axes over an hour.
  Affine at{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const RigidStep turn{{0.01f, 0.02f, 0.005f, 0.9997f}, {0, 0, 0}};
  for (int frame = 0; frame < 3600 * 60; ++frame) at = move_root(at, turn);
  double longest = 0;
  for (const auto& row : at.rows) {
    double squared = 0;
    for (int c = 0; c < 3; ++c) squared += static_cast<double>(row[c]) * static_cast<double>(row[c]);
    longest = std::fmax(longest, std::fabs(std::sqrt(squared) - 1));
  }
  std::printf("after an hour axes are off by %.2g\n", longest);
  EXPECT_LT(longest, 1e-4);
}

// An hour of straight on, and of a wide curve, at 60 frames a second: against products of matrices in double.
TEST(RootMotion, PlacesInDoubleDoNotDrift) {
  for (const float turn : {0.0f, 1e-4f}) {
    const RigidStep step{{0, turn, 0, std::sqrt(1 - turn * turn)}, {0.003f, 0, 0.0237f}};
    RootPlace place{{0, 0.6, 0, 0.8}, {5, 0, -2}};
    Affine in_floats = world_from_model(place);
    Frame want = frame_of(0, 0.6, 0, 0.8, 5, 0, -2);
    for (int frame = 0; frame < 3600 * 60; ++frame) {
      place = move_root(place, step);
      in_floats = move_root(in_floats, step);
      want = want * frame_of(step);
    }
    const Affine at = world_from_model(place);
    double off = 0, off_in_floats = 0;
    for (int row = 0; row < 3; ++row) {
      off = std::fmax(off, std::fabs(place.translation[row] - want.place[row]));
      off_in_floats = std::fmax(off_in_floats, std::fabs(wide(in_floats.rows[row][3]) - want.place[row]));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(wide(at.rows[row][c]), want.turn[row][c], 1e-6) << row << ' ' << c;
      EXPECT_EQ(at.rows[row][3], static_cast<float>(place.translation[row]));
    }
    std::printf("after an hour a place is off by %.2g m in double, %.2g m in floats\n", off, off_in_floats);
    EXPECT_LT(off, 1e-6);
  }
}

bool is_finite_step(const RigidStep& s) {
  float sum = 0;
  for (const float x : s.rotation) sum += 0 * x;
  for (const float x : s.translation) sum += 0 * x;
  return sum == 0;
}

TEST(RootMotion, OfAnyBitsIsFiniteOrRefused) {
  Random random(9);
  int ok = 0, refused = 0;
  for (int round = 0; round < 100000; ++round) {
    std::vector<RootKey> keys(random.below(4));
    for (RootKey& k : keys) {
      k.time_s = test::any_float(random, 2, 2);
      for (float& x : k.rotation) x = test::any_float(random, 2, 2);
      for (float& x : k.translation) x = test::any_float(random, 2, 2);
    }
    const ClipMotion motion{.duration_s = test::any_float(random, 2, 2), .root = keys};
    const auto playback = [&] {
      return Playback{static_cast<double>(test::any_float(random, 2, 2)), test::any_float(random, 2, 2),
                      static_cast<PlayMode>(random.below(4)), random.below(2) == 0,
                      static_cast<std::int32_t>(random.bits() << 1)};
    };
    RigidStep steps[3];
    float weights[2] = {test::any_float(random, 2, 2), 1};
    const Playback before = playback();
    Playback after = random.below(2) == 0 ? playback() : before;
    if (random.below(4) == 0) after = {.turns = after.turns};
    for (const Status status :
         {sample_root(motion, test::any_float(random, 2, 2), steps[0]), root_step(motion, before, after, steps[1]),
          blend_root_steps({steps, 2}, weights, steps[2])})
      ++(status == Status::ok ? ok : refused);
    for (const RigidStep& s : steps) ASSERT_TRUE(is_finite_step(s)) << "round " << round;
    RigidStep wild;
    for (float& x : wild.rotation) x = test::any_float(random, 2, 2);
    for (float& x : wild.translation) x = test::any_float(random, 2, 2);
    static_cast<void>(blend_root_steps({&wild, 1}, {&weights[1], 1}, steps[0]));
    ASSERT_TRUE(is_finite_step(steps[0])) << "round " << round;
  }
  EXPECT_GT(ok, 50000);
  EXPECT_GT(refused, 50000);
}

TEST(RootMotion, OfBadCallsIsRefused) {
  const test::CallErrors errors;
  const std::vector<RootKey> keys = {{0, {0, 0, 0, 1}, {}}, {1, {0, 0, 0, 1}, {0, 0, 2}}};
  const ClipMotion motion{.duration_s = 1, .root = keys}, null{.duration_s = 1, .root = {nullptr, 2}};
  RigidStep out;
  EXPECT_EQ(sample_root(motion, test::kNan, out), Status::bad_argument);
  EXPECT_EQ(sample_root(null, 0, out), Status::bad_argument);
  EXPECT_EQ(root_step(null, {}, {}, out), Status::bad_argument);
  EXPECT_EQ(root_step(motion, {}, {.time_s = 2}, out), Status::bad_argument);
  EXPECT_EQ(root_step(motion, {}, {.mode = PlayMode::once}, out), Status::bad_argument);
  const RigidStep steps[2] = {};
  const float one[1] = {1}, below[2] = {1, -1}, nan[2] = {1, test::kNan}, huge[2] = {1, 2e6f};
  EXPECT_EQ(blend_root_steps(steps, one, out), Status::bad_argument);
  EXPECT_EQ(blend_root_steps(steps, below, out), Status::bad_argument);
  EXPECT_EQ(blend_root_steps(steps, nan, out), Status::bad_argument);
  EXPECT_EQ(blend_root_steps(steps, huge, out), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
