// What several functions ask of a motion and of a step of a playback, and where such a step is on the unrolled line.
#pragma once

#include "core/check.h"
#include "marrow/clip_motion.h"
#include "marrow/playback.h"

namespace marrow {

// Whether the phase marks cut the clip into segments.
BadCall check_marks(const ClipMotion& motion);

// Whether `after` may be `before` after a step in this clip.
BadCall check_step(const ClipMotion& motion, const Playback& before, const Playback& after);

// A place on the line that time runs along when a loop is unrolled. A round of ping_pong goes to the end and back.
struct LinePlace {
  std::int64_t round;
  bool returning;  // so later places have earlier times; never at an end of the clip
  double time_s;
};
struct LineStep {
  LinePlace from, to;
  bool forward;
};

// Precondition: check_step().
LineStep line_step(const Playback& before, const Playback& after, float duration_s);

}  // namespace marrow
