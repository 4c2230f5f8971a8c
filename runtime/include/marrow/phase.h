// Phase: clips of different lengths go through their steps together, so that blended feet come down at one time.
//
// Phase marks cut a clip into segments: two for a walk, one a step. A place is a segment and a share of it, and means
// the same in each clip of a group. A group has one Phase, which advance_phase() moves on; a clip's time follows from
// it alone, so no clip can drift.
#pragma once

#include <cstdint>

#include "marrow/api.h"
#include "marrow/clip_motion.h"
#include "marrow/playback.h"
#include "marrow/status.h"

namespace marrow {

// Where a group of clips is: plain numbers that may be set, copied and stored at will.
struct Phase {
  double share = 0;           // of the segment: 0 … below 1
  std::uint32_t segment = 0;  // of the group; a clip of n marks takes it modulo n
  // Segments that the last advance_phase() passed, below 0 backwards. Stops at ±2147483647.
  std::int32_t passed = 0;
};

// A clip of a group.
struct PhaseClip {
  const ClipMotion* motion = nullptr;  // its duration and phase marks; without marks it is one segment from 0 on
  float weight = 0;                    // 0 … 1e6
};

// The place of a clip at time_s, with `passed` 0: where a group begins that takes over from this clip. time_s outside
// the clip counts as its nearest end.
// Errors: bad_argument if time_s is no number, or the duration and the marks are not as clip_motion.h has them;
// nothing is written. Cost: over the marks.
MARROW_API Status phase_at(const ClipMotion& motion, float time_s, Phase& out);

// Moves `phase` on by dt_s seconds; below 0 backwards.
//
// A segment takes the mean of what it takes in each clip, by weight: d = Σ w d_c / Σ w. A group of clips of different
// numbers of marks has the least common multiple of them as its number of segments, at most kMaxMarks: a clip of two
// marks goes twice through itself while one of four goes once. If the durations are 0 nothing moves.
//
// Errors: bad_argument if there is no clip, a motion is null or as phase_at() refuses it, the common multiple is more
// than kMaxMarks, a weight is out of range or all are 0, `phase` is not a place, or dt_s is not finite; nothing is
// written. Cost: over the group's segments and clips. Thread-safe on different phases.
MARROW_API Status advance_phase(Span<const PhaseClip> clips, float dt_s, Phase& phase);

// The playback of one clip of the group, now and before the last step: `before` and `after` are the group's phase
// before and after one advance_phase(). was, now: of mode loop, as advance() would leave them, now.turns included,
// for events_between(), root_step() and clip_time(). Errors: bad_argument if the motion is as phase_at() refuses it, or
// a phase is not a place; nothing is written.
MARROW_API Status follow_phase(const ClipMotion& motion, const Phase& before, const Phase& after, Playback& was,
                               Playback& now);

}  // namespace marrow
