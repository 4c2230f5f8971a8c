// Phase: against time laid out on a line, segment by segment, and arithmetic by hand.
#include "marrow/phase.h"

#include <cmath>
#include <cstdio>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/events.h"
#include "support/bad_numbers.h"
#include "support/call_errors.h"
#include "support/rig.h"
#include "unit/motion/any_bits.h"

namespace marrow {
namespace {

using test::Random;

struct TestCycle {
  float duration_s;
  std::vector<float> marks;
  std::vector<ClipEvent> events;  // one at each mark

  ClipMotion view() const { return {.duration_s = duration_s, .events = events, .phase_marks = marks}; }
  std::size_t count() const { return marks.empty() ? 1 : marks.size(); }
  // Seconds from the clip's start to the beginning of a segment, counted on over its rounds.
  double start(std::int64_t segment) const {
    const auto n = static_cast<std::int64_t>(count());
    const std::int64_t round = segment >= 0 ? segment / n : -((n - 1 - segment) / n);
    const float mark = marks.empty() ? 0 : marks[static_cast<std::size_t>(segment - round * n)];
    return static_cast<double>(round) * static_cast<double>(duration_s) + static_cast<double>(mark);
  }
  double length(std::int64_t segment) const { return start(segment + 1) - start(segment); }
};

TestCycle some_cycle(Random& random, std::uint32_t marks) {
  TestCycle out{static_cast<float>(random.between(0.25, 3)), {}, {}};
  // Ascending, whatever comes.
  std::vector<double> at(marks + 1);
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = (i > 0 ? at[i - 1] : 0) + random.between(0.05, 1);
  const double before = random.below(2) == 0 ? at[0] : 0;
  for (std::size_t i = 0; i < marks; ++i)
    out.marks.push_back(static_cast<float>((at[i] - at[0] + before) / (at[marks] - at[0] + before)) * out.duration_s);
  for (const float mark : out.marks) out.events.push_back({mark, mark, 0, 0});
  return out;
}

struct TestGroup {
  std::vector<TestCycle> cycles;
  std::vector<ClipMotion> motions;
  std::vector<PhaseClip> clips;
  std::int64_t segments;

  double length(std::int64_t segment) const {
    double sum = 0, whole = 0;
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      sum += static_cast<double>(clips[c].weight) * cycles[c].length(segment);
      whole += static_cast<double>(clips[c].weight);
    }
    return sum / whole;
  }
};

TestGroup some_group(Random& random) {
  static constexpr std::uint32_t kSets[][4] = {{2, 2, 2, 2}, {2, 4, 1, 4}, {3, 2, 6, 6}, {0, 0, 1, 1}, {5, 3, 2, 30}};
  const auto& set = kSets[random.below(5)];
  TestGroup out;
  out.segments = set[3] == 2 ? 2 : set[3];
  for (int c = 0; c < 3; ++c) out.cycles.push_back(some_cycle(random, set[c]));
  for (const TestCycle& cycle : out.cycles) out.motions.push_back(cycle.view());
  for (int c = 0; c < 3; ++c)
    out.clips.push_back(
        {&out.motions[static_cast<std::size_t>(c)], c == 0 ? 0.5f : static_cast<float>(random.below(3))});
  return out;
}

// Where a group is on the line of its segments, `seconds` after the beginning of segment 0.
struct Place {
  std::int64_t segment;
  double share;
};
Place place_after(const TestGroup& group, double seconds) {
  double round_s = 0;
  for (std::int64_t i = 0; i < group.segments; ++i) round_s += group.length(i);
  const double rounds = std::floor(seconds / round_s);
  double left = seconds - rounds * round_s;
  std::int64_t i = 0;
  while (i + 1 < group.segments && left >= group.length(i)) left -= group.length(i++);
  return {static_cast<std::int64_t>(rounds) * group.segments + i, left / group.length(i)};
}

// Through a thousand rounds and more, forwards and backwards: where each clip is, counted on over its rounds, follows
// from the seconds that went by.
TEST(Phase, AGroupsClipsGoTogetherWithoutDrift) {
  Random random(21);
  int compared = 0;
  double worst = 0, most_rounds = 0;
  for (int round = 0; round < 1000; ++round) {
    const TestGroup group = some_group(random);
    Phase phase;
    double seconds = 0, backwards = random.below(3) == 0 ? -1 : 1;
    std::vector<double> at(3), moved(3);
    for (std::size_t c = 0; c < 3; ++c) at[c] = group.cycles[c].start(0);
    for (int step = 0; step < 60; ++step) {
      const float dt_s =
          static_cast<float>(backwards * (random.below(3) == 0 ? random.between(0, 90) : random.between(0, 0.1)));
      const Phase before = phase;
      ASSERT_EQ(advance_phase(group.clips, dt_s, phase), Status::ok);
      seconds += static_cast<double>(dt_s);
      const Place place = place_after(group, seconds);
      for (std::size_t c = 0; c < 3; ++c) {
        Playback from, to;
        ASSERT_EQ(follow_phase(group.motions[c], before, phase, from, to), Status::ok);
        ASSERT_TRUE(to.time_s >= 0 && to.time_s < static_cast<double>(group.cycles[c].duration_s));
        // A step begins where the one before ended, to the bit.
        const double duration_s = static_cast<double>(group.cycles[c].duration_s);
        if (step > 0) {
          ASSERT_EQ(from.time_s, at[c] - std::floor(at[c] / duration_s) * duration_s);
        }
        at[c] = to.time_s;
        moved[c] += to.time_s - from.time_s + to.turns * duration_s;
        const double want = group.cycles[c].start(place.segment) + place.share * group.cycles[c].length(place.segment);
        const double off = std::fabs(moved[c] - (want - group.cycles[c].start(0)));
        ASSERT_LT(off, 1e-9) << "round " << round << ", step " << step << ", clip " << c;
        worst = std::fmax(worst, off);
        most_rounds = std::fmax(most_rounds, std::fabs(moved[c]) / duration_s);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 180000);
  EXPECT_GT(most_rounds, 1000);
  std::printf("%d places, at most %.2g s off\n", compared, worst);
}

TEST(Phase, FeetComeDownAtOneTime) {
  Random random(22);
  std::size_t steps = 0;
  for (int round = 0; round < 300; ++round) {
    TestGroup group = some_group(random);
    Phase phase{.share = 0.5};
    for (int frame = 0; frame < 100; ++frame) {
      for (PhaseClip& clip : group.clips) clip.weight = static_cast<float>(random.between(0.1, 1));
      const Phase before = phase;
      ASSERT_EQ(advance_phase(group.clips, static_cast<float>(random.between(-0.2, 0.6)), phase), Status::ok);
      // Each clip meets as many marks as the group passes, whatever its length.
      for (const ClipMotion& motion : group.motions) {
        if (motion.events.empty()) continue;
        Playback from, to;
        ASSERT_EQ(follow_phase(motion, before, phase, from, to), Status::ok);
        std::vector<EventHit> hits(motion.events.size);
        std::size_t met = 0, count = 0;
        ASSERT_EQ(events_between(motion, from, to, false, hits, met), Status::ok);
        for (std::size_t i = 0; i < met; ++i) count += hits[i].count;
        ASSERT_EQ(count, static_cast<std::size_t>(std::abs(phase.passed))) << "round " << round << ", frame " << frame;
        steps += count;
      }
    }
  }
  EXPECT_GT(steps, 20000u);
}

TEST(Phase, OfAClipGoesThereAndBack) {
  Random random(23);
  for (int round = 0; round < 20000; ++round) {
    const TestCycle cycle = some_cycle(random, random.below(6));
    const float time_s = cycle.duration_s * static_cast<float>(random.between(0, 1));
    Phase phase;
    ASSERT_EQ(phase_at(cycle.view(), time_s, phase), Status::ok);
    ASSERT_LT(phase.segment, cycle.count());
    ASSERT_TRUE(phase.share >= 0 && phase.share < 1);
    Playback from, to;
    ASSERT_EQ(follow_phase(cycle.view(), phase, phase, from, to), Status::ok);
    ASSERT_NEAR(to.time_s, static_cast<double>(time_s), 1e-15 * 10);
    ASSERT_EQ(to.turns, 0);
    ASSERT_EQ(to.mode, PlayMode::loop);
  }
}

TEST(Phase, IsThatOfTheMarks) {
  const float marks[] = {0.25f, 0.75f};
  const ClipMotion motion{.duration_s = 1, .phase_marks = marks};
  const auto at = [&](float time_s, std::uint32_t segment, double share) {
    Phase phase;
    EXPECT_EQ(phase_at(motion, time_s, phase), Status::ok);
    EXPECT_EQ(phase.segment, segment) << time_s;
    EXPECT_EQ(phase.share, share) << time_s;
  };
  at(0.25f, 0, 0);
  at(0.5f, 0, 0.5);
  at(0.75f, 1, 0);
  at(0, 1, 0.5);
  at(1, 1, 0.5);
  at(0.125f, 1, 0.75);
  at(-3, 1, 0.5);
  at(9, 1, 0.5);
  const ClipMotion plain{.duration_s = 2}, empty;
  Phase phase;
  EXPECT_EQ(phase_at(plain, 0.5f, phase), Status::ok);
  EXPECT_EQ(phase.share, 0.25);
  EXPECT_EQ(phase_at(plain, 2, phase), Status::ok);
  EXPECT_EQ(phase.share, 0);
  EXPECT_EQ(phase_at(empty, 2, phase), Status::ok);
  EXPECT_EQ(phase.share, 0);
}

TEST(Phase, TakesTheMeanOfWhatSegmentsTake) {
  const float slow[] = {0, 1}, fast[] = {0, 0.25f};
  const ClipMotion walk{.duration_s = 2, .phase_marks = slow}, run{.duration_s = 1, .phase_marks = fast};
  const PhaseClip clips[] = {{&walk, 1}, {&run, 3}};
  // 1 s and 0.25 s come to 0.4375 s, 1 s and 0.75 s to 0.8125 s.
  Phase phase;
  EXPECT_EQ(advance_phase(clips, 0.21875f, phase), Status::ok);
  EXPECT_EQ(phase.segment, 0u);
  EXPECT_EQ(phase.share, 0.5);
  EXPECT_EQ(advance_phase(clips, 0.21875f + 0.8125f + 0.4375f, phase), Status::ok);
  EXPECT_EQ(phase.segment, 1u);
  EXPECT_EQ(phase.share, 0);
  EXPECT_EQ(phase.passed, 3);
  EXPECT_EQ(advance_phase(clips, -0.21875f, phase), Status::ok);
  EXPECT_EQ(phase.segment, 0u);
  EXPECT_EQ(phase.share, 0.5);
  EXPECT_EQ(phase.passed, -1);
  EXPECT_EQ(advance_phase(clips, -0.21875f, phase), Status::ok);
  EXPECT_EQ(phase.segment, 0u);
  EXPECT_EQ(phase.share, 0);
  EXPECT_EQ(phase.passed, 0);
  EXPECT_EQ(advance_phase(clips, 1e30f, phase), Status::ok);
  EXPECT_EQ(phase.passed, INT32_MAX);
  EXPECT_EQ(advance_phase(clips, -1e30f, phase), Status::ok);
  EXPECT_EQ(phase.passed, -INT32_MAX);
  EXPECT_EQ(advance_phase(clips, 0, phase), Status::ok);
  EXPECT_EQ(phase.passed, 0);
  const ClipMotion empty;
  const PhaseClip nothing[] = {{&empty, 1}};
  EXPECT_EQ(advance_phase(nothing, 1, phase), Status::ok);
  EXPECT_EQ(phase.passed, 0);
}

// By hand: steps of a clip of 1 s begin at 0.75 s and, round its end, at 0.25 s.
TEST(Phase, OfACycleThatBeginsInTheMiddleOfItsClip) {
  const float marks[] = {0.75f, 0.25f};
  const ClipMotion motion{.duration_s = 1, .phase_marks = marks};
  for (const auto& [time_s, segment, share] : {std::tuple(0.75f, 0u, 0.0),
                                               {0.0f, 0u, 0.5},
                                               {0.125f, 0u, 0.75},
                                               {0.25f, 1u, 0.0},
                                               {0.5f, 1u, 0.5},
                                               {1.0f, 0u, 0.5}}) {
    Phase phase;
    ASSERT_EQ(phase_at(motion, time_s, phase), Status::ok);
    EXPECT_EQ(phase.segment, segment) << time_s;
    EXPECT_NEAR(phase.share, share, 1e-12) << time_s;
  }
  // From 0.7 s on by 0.4 s: over the begin of the cycle, and then over the end of the clip, to 0.1 s.
  Phase before, after;
  ASSERT_EQ(phase_at(motion, 0.7f, before), Status::ok);
  after = before;
  ASSERT_EQ(advance_phase({{&motion, 1}}, 0.4f, after), Status::ok);
  EXPECT_EQ(after.passed, 1);
  Playback was, now;
  ASSERT_EQ(follow_phase(motion, before, after, was, now), Status::ok);
  EXPECT_NEAR(was.time_s, 0.7, 1e-6);
  EXPECT_NEAR(now.time_s, 0.1, 1e-6);
  EXPECT_EQ(now.turns, 1);
  // And back.
  Phase back = after;
  ASSERT_EQ(advance_phase({{&motion, 1}}, -0.4f, back), Status::ok);
  ASSERT_EQ(follow_phase(motion, after, back, was, now), Status::ok);
  EXPECT_NEAR(now.time_s, 0.7, 1e-6);
  EXPECT_EQ(now.turns, -1);
}

TEST(Phase, OfBadCallsIsRefused) {
  const test::CallErrors errors;
  std::vector<float> many;
  for (int i = 0; i < 65; ++i) many.push_back(static_cast<float>(i) / 128);
  const float bad[] = {0.5f, 0.5f}, late[] = {0.5f, 1}, nan[] = {test::kNan}, early[] = {-0.5f};
  const ClipMotion good{.duration_s = 1}, of_64{.duration_s = 1, .phase_marks = {many.data(), 64}},
      of_63{.duration_s = 1, .phase_marks = {many.data(), 63}};
  Phase phase{0.5, 0, 7};
  const auto refused = [&](Span<const PhaseClip> clips, float dt_s = 0.1f) {
    EXPECT_EQ(advance_phase(clips, dt_s, phase), Status::bad_argument);
    EXPECT_EQ(phase.passed, 7);
  };
  const PhaseClip clip{&good, 1};
  refused({});
  refused({nullptr, 1});
  refused({{nullptr, 1}});
  refused({{&good, 0}});
  refused({{&good, -1}});
  refused({{&good, 2e6f}});
  refused({{&good, test::kNan}});
  refused({{&good, 1}, {&of_64, 1}, {&of_63, 1}});
  refused({&clip, 1}, test::kInfinity);
  EXPECT_EQ(advance_phase({&clip, 1}, 0.1f, phase = {0.5, 0, 7}), Status::ok);
  for (const Span<const float> marks :
       {Span<const float>(bad), Span<const float>(late), Span<const float>(nan), Span<const float>(early),
        Span<const float>(many), Span<const float>(nullptr, 1)}) {
    const ClipMotion motion{.duration_s = 1, .phase_marks = marks};
    Playback from, to;
    Phase out;
    EXPECT_EQ(phase_at(motion, 0, out), Status::bad_argument);
    EXPECT_EQ(follow_phase(motion, {}, {}, from, to), Status::bad_argument);
    phase = {0.5, 0, 7};
    refused({{&motion, 1}});
  }
  Playback from, to;
  Phase out;
  EXPECT_EQ(phase_at(good, test::kNan, out), Status::bad_argument);
  for (const double share : {-0.1, 1.0, static_cast<double>(test::kNan)}) {
    EXPECT_EQ(follow_phase(good, {share, 0, 0}, {}, from, to), Status::bad_argument);
    EXPECT_EQ(follow_phase(good, {}, {share, 0, 0}, from, to), Status::bad_argument);
    phase = {share, 0, 7};
    refused({&clip, 1});
  }
}

TEST(Phase, OfAnyBitsIsAPlaceOrRefused) {
  Random random(24);
  int ok = 0, refused = 0;
  for (int round = 0; round < 100000; ++round) {
    float marks[2][3];
    ClipMotion motions[2];
    PhaseClip clips[2];
    for (int c = 0; c < 2; ++c) {
      for (float& mark : marks[c]) mark = test::any_float(random, 3, 2);
      motions[c] = {.duration_s = test::any_float(random, 3, 2), .phase_marks = {marks[c], random.below(3)}};
      clips[c] = {&motions[c], test::any_float(random, 3, 2)};
    }
    Phase phase{random.between(-0.1, 1.1), random.bits(), static_cast<std::int32_t>(random.bits() << 1)};
    const Phase before = phase;
    const Status status = advance_phase(clips, test::any_float(random, 3, 2), phase);
    ++(status == Status::ok ? ok : refused);
    if (status == Status::ok) {
      ASSERT_TRUE(phase.share >= 0 && phase.share < 1) << "round " << round;
    }
    Playback from, to;
    if (follow_phase(motions[0], before, phase, from, to) == Status::ok) {
      ASSERT_TRUE(to.time_s >= 0 && to.time_s <= static_cast<double>(motions[0].duration_s)) << "round " << round;
    }
    if (phase_at(motions[0], test::any_float(random, 3, 2), phase) == Status::ok) {
      ASSERT_TRUE(phase.share >= 0 && phase.share < 1 && phase.segment < 3) << "round " << round;
    }
  }
  EXPECT_GT(ok, 5000);
  EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace marrow
