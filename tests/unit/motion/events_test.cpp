// events_between: against a walk over an unrolled line in whole ticks, and arithmetic by hand.
#include "marrow/events.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/call_errors.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::Random;

constexpr int kTicks = 1024;  // a second; every time here is a number of them, so sums of floats are exact

struct TestEvents {
  std::vector<int> ticks;  // ascending, 0 … duration
  int duration;
  std::vector<ClipEvent> events;

  TestEvents(std::vector<int> at, int of) : ticks(std::move(at)), duration(of) {
    for (const int t : ticks) {
      const float time_s = static_cast<float>(t) / kTicks;
      events.push_back({time_s, time_s, 0, 0});
    }
  }
  ClipMotion view() const { return {.duration_s = static_cast<float>(duration) / kTicks, .events = events}; }
};

// Where the clip is at a tick of the line, and the tick in the clip that stands for it.
int folded(std::int64_t line, PlayMode mode, int duration) {
  if (mode == PlayMode::once) return static_cast<int>(std::clamp<std::int64_t>(line, 0, duration));
  const std::int64_t period = mode == PlayMode::loop ? duration : 2 * duration;
  const auto place = static_cast<int>(((line % period) + period) % period);
  return place <= duration ? place : 2 * duration - place;
}

struct Walked {
  std::map<std::uint32_t, std::int64_t> counts;    // by event
  std::map<std::uint32_t, std::int64_t> first_at;  // ticks from the start of the step
};

// Tick by tick from one place of the line to another.
Walked walk_line(const TestEvents& t, PlayMode mode, std::int64_t from, std::int64_t to, bool first) {
  Walked out;
  const std::int64_t sign = from <= to ? 1 : -1;
  for (std::int64_t at = first ? from : from + sign; first || from != to ? (to - at) * sign >= 0 : false; at += sign) {
    if (mode == PlayMode::once && (at < 0 || at > t.duration)) continue;
    for (std::uint32_t e = 0; e < t.ticks.size(); ++e) {
      const int own = mode == PlayMode::loop && t.ticks[e] == t.duration ? 0 : t.ticks[e];
      if (folded(at, mode, t.duration) != own) continue;
      ++out.counts[e];
      out.first_at.try_emplace(e, (at - from) * sign);
    }
  }
  return out;
}

void expect_walked(const TestEvents& t, const Playback& before, const Playback& after, bool first,
                   const Walked& walked) {
  std::vector<EventHit> hits(t.ticks.size() + 1);
  std::size_t met = 99;
  ASSERT_EQ(events_between(t.view(), before, after, first, hits, met), Status::ok);
  ASSERT_EQ(met, walked.counts.size());
  std::int64_t last = 0;
  for (std::size_t i = 0; i < met; ++i) {
    const auto counted = walked.counts.find(hits[i].event);
    ASSERT_NE(counted, walked.counts.end()) << "event " << hits[i].event;
    ASSERT_EQ(hits[i].count, counted->second) << "event " << hits[i].event;
    const std::int64_t at = walked.first_at.at(hits[i].event);
    ASSERT_LE(last, at) << "not in the order in which they are met";
    last = at;
  }
}

TestEvents some_events(Random& random) {
  const int duration = 1 + static_cast<int>(random.below(60));
  std::vector<int> at;
  for (std::uint32_t i = random.below(6); i > 0; --i) {
    const std::uint32_t kind = random.below(6);
    at.push_back(kind == 0   ? 0
                 : kind == 1 ? duration
                             : static_cast<int>(random.below(static_cast<std::uint32_t>(duration) + 1)));
  }
  std::sort(at.begin(), at.end());
  return {at, duration};
}

// What a playback's time is on the line when it begins.
std::int64_t line_of(const Playback& p, int duration) {
  const auto ticks = static_cast<std::int64_t>(p.time_s * kTicks);
  return p.mode == PlayMode::ping_pong && p.returning ? 2 * duration - ticks : ticks;
}

// A foot that stands all through a loop comes down once, when the clip begins.
TEST(Events, ThatLastAWholeRoundDoNotBeginAgain) {
  const std::vector<ClipEvent> events = {{0, 1, 0, 0}, {0.25f, 1.25f, 0, 0}, {0.5f, 0.75f, 0, 0}};
  const ClipMotion motion{.duration_s = 1, .events = events};
  for (const float dt_s : {0.0625f, 0.75f, 2.5f, -0.375f}) {
    Playback now;
    std::vector<std::uint32_t> counts(3);
    std::vector<EventHit> hits(3);
    std::size_t met = 0;
    for (int step = 0; step < 32; ++step) {
      const Playback before = now;
      ASSERT_EQ(advance(now, 1, dt_s), Status::ok);
      ASSERT_EQ(events_between(motion, before, now, step == 0, hits, met), Status::ok);
      for (std::size_t i = 0; i < met; ++i) counts[hits[i].event] += hits[i].count;
      if (step > 0) continue;
      ASSERT_GE(met, 2u);
      EXPECT_EQ(hits[0].event, 0u);
      EXPECT_EQ(hits[1].event, 1u);
    }
    EXPECT_EQ(counts[0], 1u) << dt_s;
    EXPECT_EQ(counts[1], 1u) << dt_s;
    EXPECT_EQ(counts[2], static_cast<std::uint32_t>(32 * std::fabs(dt_s))) << dt_s;
  }
  Playback once{.mode = PlayMode::once};
  const Playback before = once;
  EventHit hit;
  std::size_t met = 0;
  ASSERT_EQ(advance(once, 1, 0.375f), Status::ok);
  ASSERT_EQ(events_between(motion, before, once, false, {&hit, 1}, met), Status::ok);
  EXPECT_EQ(met, 1u);
  EXPECT_EQ(hit.event, 1u);
}

TEST(Events, AreThoseOfAWalkOverTheUnrolledLine) {
  Random random(7);
  int cases = 0, hits = 0, turned = 0;
  for (int round = 0; round < 30000 && !testing::Test::HasFailure(); ++round) {
    const TestEvents t = some_events(random);
    Playback p;
    p.mode = static_cast<PlayMode>(random.below(3));
    p.time_s = static_cast<double>(random.below(static_cast<std::uint32_t>(t.duration) + 1)) / kTicks;
    if (p.mode == PlayMode::ping_pong) p.returning = random.below(2) == 0;
    const float speeds[] = {1, -1, 2, -2, 3, -0.5f};
    p.speed = speeds[random.below(6)];
    std::int64_t line = line_of(p, t.duration);
    for (int step = 0; step < 5; ++step) {
      const int most = random.below(4) == 0 ? 300 : t.duration;
      const int dt = random.below(5) == 0 ? 0 : 2 * static_cast<int>(random.below(static_cast<std::uint32_t>(most)));
      const Playback before = p;
      ASSERT_EQ(advance(p, t.view().duration_s, static_cast<float>(dt) / kTicks), Status::ok);
      std::int64_t to = line + static_cast<std::int64_t>(static_cast<float>(dt) * p.speed);
      if (p.mode == PlayMode::once) to = std::clamp<std::int64_t>(to, 0, t.duration);
      const bool first = step == 0 || random.below(8) == 0;
      SCOPED_TRACE("round " + std::to_string(round) + ", step " + std::to_string(step));
      const Walked walked = walk_line(t, p.mode, line, to, first);
      expect_walked(t, before, p, first, walked);
      line = to;
      ++cases;
      hits += static_cast<int>(walked.counts.size());
      turned += p.turns != 0;
    }
  }
  EXPECT_GE(cases, 100000);
  EXPECT_GT(hits, 100000);
  EXPECT_GT(turned, 30000);
  std::printf("%d steps, %d events met, %d steps with turns\n", cases, hits, turned);
}

// floor(a / b) for b > 0.
__extension__ typedef __int128 Wide;
Wide floor_of(Wide a, Wide b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// How many k have from < at + k period ≤ to; backwards to ≤ at + k period < from.
Wide multiples(Wide from, Wide to, Wide at, Wide period) {
  return from <= to ? floor_of(to - at, period) - floor_of(from - at, period)
                    : floor_of(from - at - 1, period) - floor_of(to - at - 1, period);
}

TEST(Events, OfHugeStepsAreCountedInIntegers) {
  Random random(8);
  int huge = 0;
  for (int round = 0; round < 20000; ++round) {
    const TestEvents t = some_events(random);
    Playback p;
    p.mode = random.below(2) == 0 ? PlayMode::loop : PlayMode::ping_pong;
    p.time_s = static_cast<double>(random.below(static_cast<std::uint32_t>(t.duration))) / kTicks;
    p.speed = random.below(2) == 0 ? 1.0f : -1.0f;
    const Wide from = line_of(p, t.duration), moved = Wide{1 + random.below(1u << 24)} << random.below(14);
    const Wide to = p.speed > 0 ? from + moved : from - moved;
    const Playback before = p;
    ASSERT_EQ(advance(p, t.view().duration_s, static_cast<float>(moved) / kTicks), Status::ok);
    if (p.turns == INT32_MAX || p.turns == -INT32_MAX) continue;
    std::vector<EventHit> hits(t.ticks.size());
    std::size_t met = 0;
    ASSERT_EQ(events_between(t.view(), before, p, false, hits, met), Status::ok);
    std::vector<Wide> counts(t.ticks.size());
    for (std::size_t i = 0; i < met; ++i) counts[hits[i].event] = hits[i].count;
    for (std::size_t e = 0; e < t.ticks.size(); ++e) {
      const bool back = p.mode == PlayMode::ping_pong && t.ticks[e] > 0 && t.ticks[e] < t.duration;
      const Wide period = p.mode == PlayMode::loop ? t.duration : 2 * t.duration;
      Wide want = multiples(from, to, t.ticks[e], period);
      if (back) want += multiples(from, to, -t.ticks[e], period);
      ASSERT_TRUE(counts[e] == want) << "round " << round << ", event " << e;
    }
    huge += std::abs(p.turns) > 1000000;
  }
  EXPECT_GT(huge, 1000);
}

std::vector<std::uint32_t> met_in(const ClipMotion& motion, Playback p, float dt_s, bool first = false) {
  const Playback before = p;
  EXPECT_EQ(advance(p, motion.duration_s, dt_s), Status::ok);
  std::vector<EventHit> hits(8);
  std::size_t met = 0;
  EXPECT_EQ(events_between(motion, before, p, first, hits, met), Status::ok);
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < met; ++i) out.push_back(hits[i].event);
  return out;
}

using List = std::vector<std::uint32_t>;

TEST(Events, ComeInTheOrderInWhichTheyAreMet) {
  const TestEvents t({0, 256, 512, 768, 1024}, 1024);
  const ClipMotion motion = t.view();
  EXPECT_EQ(met_in(motion, {.time_s = 0.6}, 0.5f), (List{3, 4, 0}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.6}, 1), (List{3, 4, 0, 1, 2}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.4, .speed = -1}, 0.75f), (List{1, 0, 4, 3}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.6, .mode = PlayMode::ping_pong}, 1.2f), (List{3, 4, 2, 1}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.6, .mode = PlayMode::ping_pong, .returning = true}, 1.2f), (List{2, 1, 0}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.6, .mode = PlayMode::once}, 9), (List{3, 4}));
  EXPECT_EQ(met_in(motion, {.mode = PlayMode::once}, 9), (List{1, 2, 3, 4}));
  EXPECT_EQ(met_in(motion, {.mode = PlayMode::once}, 9, true), (List{0, 1, 2, 3, 4}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.5}, 0, true), (List{2}));
  EXPECT_EQ(met_in(motion, {.time_s = 0.5}, 0), List{});
}

TEST(Events, OfATimeOutsideTheClipAreThoseOfThePlaceThere) {
  const TestEvents t({256, 768}, 1024);
  const ClipMotion motion = t.view();
  EXPECT_EQ(met_in(motion, {.time_s = 5.5}, 0.5f), List{1});
  EXPECT_EQ(met_in(motion, {.time_s = 1}, 0.5f), List{0});
  EXPECT_EQ(met_in(motion, {.time_s = 1, .speed = -1}, 0.5f), List{1});
  EXPECT_EQ(met_in(motion, {.time_s = -0.5}, 0.25f), List{1});
}

TEST(Events, WithoutRoomAreCounted) {
  const TestEvents t({256, 768}, 1024);
  Playback p;
  ASSERT_EQ(advance(p, 1, 5.5f), Status::ok);
  EventHit one[1];
  std::size_t met = 0;
  ASSERT_EQ(events_between(t.view(), {}, p, false, one, met), Status::ok);
  EXPECT_EQ(met, 2u);
  EXPECT_EQ(one[0].event, 0u);
  EXPECT_EQ(one[0].count, 6u);
  ASSERT_EQ(events_between(t.view(), {}, p, false, {}, met), Status::ok);
  EXPECT_EQ(met, 2u);
}

TEST(Events, OfMoreTurnsThanCanBeCountedStop) {
  const TestEvents t({256}, 1024);
  for (const PlayMode mode : {PlayMode::loop, PlayMode::ping_pong}) {
    for (const float speed : {1.0f, -1.0f}) {
      Playback p{.speed = speed, .mode = mode};
      ASSERT_EQ(advance(p, 1, 1e30f), Status::ok);
      EventHit hit[1];
      std::size_t met = 0;
      ASSERT_EQ(events_between(t.view(), {.mode = mode}, p, true, hit, met), Status::ok);
      ASSERT_EQ(met, 1u);
      EXPECT_NEAR(hit[0].count, 2147483647.0, 2);
    }
  }
}

TEST(Events, OfAClipWithoutLengthAreMetFirstAlone) {
  const TestEvents t({0}, 0);
  for (const PlayMode mode : {PlayMode::once, PlayMode::loop, PlayMode::ping_pong}) {
    EXPECT_EQ(met_in(t.view(), {.mode = mode}, 1, true), List{0});
    EXPECT_EQ(met_in(t.view(), {.mode = mode}, 1), List{});
  }
}

TEST(Events, OfBadCallsAreRefused) {
  const TestEvents t({256}, 1024);
  const ClipMotion motion = t.view();
  const test::CallErrors errors;
  EventHit hits[1];
  std::size_t met = 7;
  const auto refused = [&](const ClipMotion& m, const Playback& before, const Playback& after) {
    EXPECT_EQ(events_between(m, before, after, false, hits, met), Status::bad_argument);
    EXPECT_EQ(met, 7u);
  };
  refused(motion, {.time_s = static_cast<double>(test::kNan)}, {});
  refused(motion, {}, {.time_s = 1.5});
  refused(motion, {}, {.time_s = -0.1});
  refused(motion, {}, {.mode = PlayMode::once});
  refused(motion, {.time_s = 2, .mode = PlayMode::ping_pong}, {.mode = PlayMode::ping_pong});
  ClipMotion bad = motion;
  bad.duration_s = test::kNan;
  refused(bad, {}, {});
  bad = motion;
  bad.events = {nullptr, 1};
  refused(bad, {}, {});
}

TEST(Events, SpansGoOnBeyondTheEnd) {
  const ClipEvent stance{0.75f, 1.25f, 0, 0}, blow{0.5f, 0.5f, 0, 0};
  EXPECT_TRUE(is_within(stance, 0.75f, 1));
  EXPECT_TRUE(is_within(stance, 1, 1));
  EXPECT_TRUE(is_within(stance, 0.25f, 1));
  EXPECT_FALSE(is_within(stance, 0.3f, 1));
  EXPECT_FALSE(is_within(stance, 0.7f, 1));
  EXPECT_TRUE(is_within(blow, 0.5f, 1));
  EXPECT_FALSE(is_within(blow, 0.51f, 1));
}

}  // namespace
}  // namespace marrow
