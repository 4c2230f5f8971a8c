#include "marrow/phase.h"

#include "core/check.h"
#include "math/finite.h"
#include "motion/motion_rules.h"
#include "motion/phase_step.h"

namespace marrow {
namespace {

constexpr std::int64_t kMostPassed = INT32_MAX;
constexpr double kBelowOne = 1.0 - 0x1p-53;

// A clip's segments, in double.
struct Cycle {
  Span<const float> marks;
  double duration_s;

  explicit Cycle(const ClipMotion& m) : marks(m.phase_marks), duration_s(static_cast<double>(m.duration_s)) {}
  std::uint32_t count() const { return marks.empty() ? 1 : static_cast<std::uint32_t>(marks.size); }
  // On the line that goes on beyond the clip's end: below twice the duration.
  double start(std::uint32_t i) const {
    if (marks.empty()) return 0;
    return static_cast<double>(marks[i]) + (marks[i] < marks[0] ? duration_s : 0);
  }
  // The last goes on to the first mark of the next round.
  double length(std::uint32_t i) const { return (i + 1 < count() ? start(i + 1) : duration_s + start(0)) - start(i); }
};

bool is_place(const Phase& phase) {
  return 0 <= phase.share && phase.share < 1;
}

std::int64_t at_most(std::int64_t x) {
  return x > kMostPassed ? kMostPassed : x < -kMostPassed ? -kMostPassed : x;
}

// Where a clip is, and how many rounds of the clip lie before it, for `passed` segments after `segment`.
struct ClipPlace {
  std::int64_t round;
  double time_s;
};
ClipPlace place_in(const Cycle& cycle, const Phase& phase, std::uint32_t from, std::int64_t passed) {
  const std::int64_t count = cycle.count(), line = from % count + passed;
  const std::uint32_t segment = phase.segment % cycle.count();
  const std::int64_t round = line >= 0 ? line / count : -((count - 1 - line) / count);
  const double time_s = cycle.start(segment) + phase.share * cycle.length(segment);
  if (time_s < cycle.duration_s) return {round, time_s};
  return cycle.duration_s > 0 ? ClipPlace{round + 1, time_s - cycle.duration_s} : ClipPlace{round, 0};
}

std::uint32_t common_multiple(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a, y = b;
  while (y != 0) {
    const std::uint32_t rest = x % y;
    x = y;
    y = rest;
  }
  return a / x * b;
}

// The segments of a group.
struct Group {
  Span<const PhaseClip> clips;
  std::uint32_t segments = 1;
  double weight = 0;

  explicit Group(Span<const PhaseClip> of) : clips(of) {
    for (const PhaseClip& clip : clips) {
      weight += static_cast<double>(clip.weight);
      segments = common_multiple(segments, Cycle(*clip.motion).count());
    }
  }
  double length(std::uint32_t segment) const {
    double sum = 0;
    for (const PhaseClip& clip : clips) {
      const Cycle cycle(*clip.motion);
      sum += static_cast<double>(clip.weight) * cycle.length(segment % cycle.count());
    }
    return sum / weight;
  }
};

BadCall check_group(Span<const PhaseClip> clips) {
  MARROW_CHECK(!clips.empty() && holds(clips));
  std::uint32_t segments = 1;
  double weight = 0;
  for (const PhaseClip& clip : clips) {
    MARROW_CHECK(clip.motion != nullptr);
    if (const BadCall bad = check_marks(*clip.motion)) return bad;
    MARROW_CHECK(within(clip.weight, 0, 1e6f));
    weight += static_cast<double>(clip.weight);
    segments = common_multiple(segments, Cycle(*clip.motion).count());
    MARROW_CHECK(segments <= kMaxMarks && "marks whose least common multiple is at most 64");
  }
  MARROW_CHECK(weight > 0);
  return {};
}

// Over the ends of segments, less than a whole round of them, for `left_s` ≥ 0.
void walk(const Group& group, double left_s, bool forward, Phase& phase, std::int64_t& passed) {
  for (std::uint32_t i = 0; i <= group.segments; ++i) {
    const double length = group.length(phase.segment), room = (forward ? 1.0 - phase.share : phase.share) * length;
    if (left_s < room) {
      const double share = forward ? phase.share + left_s / length : phase.share - left_s / length;
      phase.share = share < 0 ? 0 : share < 1 ? share : kBelowOne;
      return;
    }
    if (!forward && left_s == room) {
      phase.share = 0;
      return;
    }
    left_s -= room;
    phase.segment = (phase.segment + (forward ? 1 : group.segments - 1)) % group.segments;
    phase.share = forward ? 0 : 1;
    passed += forward ? 1 : -1;
  }
  if (!forward) phase.share = kBelowOne;
}

}  // namespace

Status phase_at(const ClipMotion& motion, float time_s, Phase& out) {
  MARROW_REQUIRE_GOOD(check_marks(motion));
  MARROW_REQUIRE(is_number(time_s));
  const Cycle cycle(motion);
  const double time = static_cast<double>(time_s < 0 ? 0 : time_s < motion.duration_s ? time_s : motion.duration_s);
  // Where the cycle begins later in the clip, its end is at the clip's start.
  const double on_line = time < cycle.start(0) ? time + cycle.duration_s : time;
  std::uint32_t segment = cycle.count() - 1;
  while (segment > 0 && on_line < cycle.start(segment)) --segment;
  const double length = cycle.length(segment), share = length > 0 ? (on_line - cycle.start(segment)) / length : 0;
  // The end of a clip whose first mark is 0 is that mark.
  out = share < 1 ? Phase{share, segment, 0} : Phase{0, (segment + 1) % cycle.count(), 0};
  return Status::ok;
}

Status advance_phase(Span<const PhaseClip> clips, float dt_s, Phase& phase) {
  MARROW_REQUIRE_GOOD(check_group(clips));
  MARROW_REQUIRE(is_finite(dt_s));
  MARROW_REQUIRE(is_place(phase));
  advance_checked_phase(clips, dt_s, phase);
  return Status::ok;
}

void advance_checked_phase(Span<const PhaseClip> clips, float dt_s, Phase& phase) {
  const Group group(clips);
  double round_s = 0;
  for (std::uint32_t i = 0; i < group.segments; ++i) round_s += group.length(i);
  Phase moved{phase.share, phase.segment % group.segments, 0};
  if (round_s > 0) {
    const bool forward = dt_s >= 0;
    double left_s = static_cast<double>(forward ? dt_s : -dt_s);
    std::int64_t rounds = 0;
    if (left_s >= round_s) {
      const double most = static_cast<double>(kMostPassed), times = left_s / round_s;
      rounds = times < most ? static_cast<std::int64_t>(times) : kMostPassed;
      left_s = times < most ? left_s - static_cast<double>(rounds) * round_s : 0;
      if (left_s < 0) left_s = 0;
    }
    std::int64_t passed = rounds * group.segments * (forward ? 1 : -1);
    walk(group, left_s, forward, moved, passed);
    moved.passed = static_cast<std::int32_t>(at_most(passed));
  }
  phase = moved;
}

Status follow_phase(const ClipMotion& motion, const Phase& before, const Phase& after, Playback& was, Playback& now) {
  MARROW_REQUIRE_GOOD(check_marks(motion));
  MARROW_REQUIRE(is_place(before));
  MARROW_REQUIRE(is_place(after));
  follow_checked_phase(motion, before, after, was, now);
  return Status::ok;
}

void follow_checked_phase(const ClipMotion& motion, const Phase& before, const Phase& after, Playback& was,
                          Playback& now) {
  const Cycle cycle(motion);
  const ClipPlace start = place_in(cycle, before, before.segment, 0);
  const ClipPlace end = place_in(cycle, after, before.segment, after.passed);
  was = {.time_s = start.time_s};
  now = {.time_s = end.time_s, .turns = static_cast<std::int32_t>(at_most(end.round - start.round))};
}

}  // namespace marrow
