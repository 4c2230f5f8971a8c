#include "marrow/events.h"

#include "core/check.h"
#include "motion/motion_rules.h"

namespace marrow {
namespace {

// A moment that comes once a round.
struct LineMoment {
  bool returning;
  double time_s;
};

bool is_at(const LineMoment& m, const LinePlace& p) {
  return m.returning == p.returning && m.time_s == p.time_s;
}
// In a round.
bool is_behind(const LineMoment& m, const LinePlace& p) {
  if (m.returning != p.returning) return p.returning;
  return m.returning ? m.time_s > p.time_s : m.time_s < p.time_s;
}

// In a loop it never ends, so it begins once.
bool goes_on(const ClipEvent& event, float duration_s, PlayMode mode) {
  return mode == PlayMode::loop && duration_s > 0 && event.until_s >= event.time_s + duration_s;
}

// How often a step meets a moment.
std::int64_t times_met(const LineMoment& m, const LineStep& s, bool first) {
  const std::int64_t rounds = s.to.round - s.from.round, start = first && is_at(m, s.from) ? 1 : 0;
  const auto behind = [&](const LinePlace& p, bool or_at) {
    return std::int64_t{is_behind(m, p) || (or_at && is_at(m, p)) ? 1 : 0};
  };
  return start + (s.forward ? rounds + behind(s.to, true) - behind(s.from, true)
                            : behind(s.from, false) - behind(s.to, false) - rounds);
}

struct EventSearch {
  const ClipMotion& motion;
  LineStep step;
  PlayMode mode;
  bool first;
  std::size_t at_end;  // of a loop: how many of the last events count as the first

  // The moments of a loop begin with those at its end.
  std::size_t in_order(std::size_t i) const { return i < at_end ? motion.events.size - at_end + i : i - at_end; }
  double time_of(std::size_t event) const {
    const float time_s = motion.events[event].time_s;
    return mode == PlayMode::loop && !(time_s < motion.duration_s) ? 0 : static_cast<double>(time_s);
  }
  std::uint32_t count_of(std::size_t event) const {
    const double time_s = time_of(event);
    std::int64_t count = times_met({false, time_s}, step, first);
    if (mode == PlayMode::ping_pong && 0 < time_s && time_s < static_cast<double>(motion.duration_s))
      count += times_met({true, time_s}, step, first);
    return count > 0 ? static_cast<std::uint32_t>(count) : 0;
  }
};

std::size_t count_at_end(const ClipMotion& motion, PlayMode mode) {
  std::size_t count = 0;
  if (mode != PlayMode::loop) return 0;
  while (count < motion.events.size && !(motion.events[motion.events.size - 1 - count].time_s < motion.duration_s))
    ++count;
  return count;
}

// Whether times grow at first.
bool begins_later(const LineStep& step, PlayMode mode, double duration_s) {
  const bool later = step.forward != step.from.returning;
  const bool turns_at_once = step.from.time_s == (later ? duration_s : 0);
  return mode == PlayMode::ping_pong && turns_at_once ? !later : later;
}

// Most steps go forwards within a round, and meet nothing.
bool stays_in_round(const LineStep& step) {
  return step.from.round == step.to.round && !step.from.returning && !step.to.returning && step.forward;
}
std::size_t events_in_round(const ClipMotion& motion, const LineStep& step, PlayMode mode, Span<EventHit> out) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < motion.events.size; ++i) {
    const auto time_s = static_cast<double>(motion.events[i].time_s);
    if (time_s > step.to.time_s) break;
    if (!(time_s > step.from.time_s) || goes_on(motion.events[i], motion.duration_s, mode)) continue;
    if (found < out.size) out[found] = {static_cast<std::uint32_t>(i), 1};
    ++found;
  }
  return found;
}

}  // namespace

Status events_between(const ClipMotion& motion, const Playback& before, const Playback& after, bool first,
                      Span<EventHit> out, std::size_t& met) {
  MARROW_REQUIRE(holds(motion.events));
  MARROW_REQUIRE(holds(out));
  MARROW_REQUIRE_GOOD(check_step(motion, before, after));
  const LineStep step = line_step(before, after, motion.duration_s);
  if (!first && stays_in_round(step)) {
    met = events_in_round(motion, step, before.mode, out);
    return Status::ok;
  }
  const EventSearch search{motion, step, before.mode, first, count_at_end(motion, before.mode)};
  const bool later = begins_later(step, before.mode, static_cast<double>(motion.duration_s));
  const std::size_t count = motion.events.size;
  std::size_t found = 0;
  const auto meet = [&](std::size_t event, std::uint32_t times) {
    if (found < out.size) out[found] = {static_cast<std::uint32_t>(event), times};
    ++found;
  };
  for (std::size_t i = 0; first && i < count; ++i)
    if (goes_on(motion.events[i], motion.duration_s, before.mode)) meet(i, 1);
  // Those that lie ahead first, then those that are met after the clip's end, or on the way back.
  for (const bool ahead : {true, false}) {
    const bool ascending = ahead || search.mode != PlayMode::ping_pong ? later : !later;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t event = search.in_order(ascending ? i : count - 1 - i);
      if (goes_on(motion.events[event], motion.duration_s, before.mode)) continue;
      const double time_s = search.time_of(event);
      const bool is_ahead = later ? time_s > step.from.time_s : time_s < step.from.time_s;
      if ((is_ahead || (first && time_s == step.from.time_s)) != ahead) continue;
      const std::uint32_t times = search.count_of(event);
      if (times > 0) meet(event, times);
    }
  }
  met = found;
  return Status::ok;
}

}  // namespace marrow
