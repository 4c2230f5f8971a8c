#include "motion/motion_rules.h"

#include "asset/motion_fault.h"
#include "math/finite.h"

namespace marrow {
namespace {

bool is_in_clip(const Playback& playback, float duration_s) {
  return 0 <= playback.time_s && playback.time_s <= static_cast<double>(duration_s);
}

// An end belongs to the way out: the start to the next round's.
LinePlace turning_place(const Playback& p, std::int64_t round, double duration_s) {
  const bool back_at_start = p.returning && p.time_s == 0;
  return {round + (back_at_start ? 1 : 0), p.returning && !back_at_start && p.time_s < duration_s, p.time_s};
}

LineStep turning_step(const Playback& before, const Playback& after, double duration_s) {
  const std::int64_t out = before.returning ? 1 : 0, in = after.returning ? 1 : 0;
  const std::int64_t turns = after.speed < 0 ? -std::int64_t{after.turns} : std::int64_t{after.turns};
  return {turning_place(before, 0, duration_s), turning_place(after, (out + turns - in) / 2, duration_s), true};
}

// A time outside the clip is where advance() has it.
LineStep straight_step(const Playback& before, const Playback& after, float duration_s) {
  Playback from;
  from.time_s = before.time_s;
  from.mode = before.mode;
  static_cast<void>(advance(from, duration_s, 0));
  const bool at_end =
      after.mode == PlayMode::loop && duration_s > 0 && !(after.time_s < static_cast<double>(duration_s));
  const std::int64_t turns = after.mode == PlayMode::loop ? std::int64_t{after.turns} - from.turns : 0;
  return {{0, false, from.time_s}, {turns + (at_end ? 1 : 0), false, at_end ? 0 : after.time_s}, true};
}

}  // namespace

BadCall check_marks(const ClipMotion& motion) {
  MARROW_CHECK(is_finite(motion.duration_s) && motion.duration_s >= 0);
  MARROW_CHECK(holds(motion.phase_marks));
  const MotionFault fault = find_fault_of_marks(motion);
  MARROW_CHECK(fault.rule == nullptr && "phase marks that go once round the clip");
  return {};
}

BadCall check_step(const ClipMotion& motion, const Playback& before, const Playback& after) {
  MARROW_CHECK(is_finite(motion.duration_s) && motion.duration_s >= 0);
  MARROW_CHECK(before.mode == after.mode && after.mode <= PlayMode::ping_pong);
  MARROW_CHECK(is_finite(before.time_s));
  MARROW_CHECK(is_in_clip(before, motion.duration_s) || before.mode != PlayMode::ping_pong);
  MARROW_CHECK(is_in_clip(after, motion.duration_s));
  return {};
}

LineStep line_step(const Playback& before, const Playback& after, float duration_s) {
  LineStep step = before.mode == PlayMode::ping_pong ? turning_step(before, after, static_cast<double>(duration_s))
                                                     : straight_step(before, after, duration_s);
  const LinePlace &a = step.from, &b = step.to;
  if (a.round != b.round) {
    step.forward = a.round < b.round;
  } else if (a.returning != b.returning) {
    step.forward = b.returning;
  } else {
    step.forward = a.returning ? b.time_s <= a.time_s : a.time_s <= b.time_s;
  }
  return step;
}

}  // namespace marrow
