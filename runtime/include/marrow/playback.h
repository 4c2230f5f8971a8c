// Playback: where in its clip a character is, moved on from frame to frame.
#pragma once

#include <cstdint>

#include "marrow/api.h"
#include "marrow/status.h"

namespace marrow {

// What happens at the ends of a clip.
enum class PlayMode : std::uint8_t {
  once,       // time stops at the end
  loop,       // time goes on from the other end; the last pose and the first are one moment
  ping_pong,  // time turns round
};

// The state of a playing clip: plain numbers that may be set, copied and stored at will. A clip that is to run
// backwards once begins with time_s = its duration.
struct Playback {
  double time_s = 0;               // in the clip
  float speed = 1;                 // seconds of the clip a second; 0 pauses, below 0 runs backwards
  PlayMode mode = PlayMode::loop;  // what happens at the ends
  bool returning = false;          // ping_pong: on the way back, so time runs against speed
  // Of the last advance(). loop: how often time went from the clip's end to its start, less how often the other way
  // round; ping_pong: how often time turned; once: 0. Stops at ±2147483647.
  std::int32_t turns = 0;
};
static_assert(sizeof(Playback) <= 128);

// Moves `playback` on by dt_s seconds times its speed, in a clip of `duration_s`. Whatever lies beyond an end counts,
// however many times over: a loop loses no time and shows none twice, and so does a turn. Afterwards time_s is in
// 0 … duration_s, and below duration_s in a loop; an end that is reached exactly is passed or turned at only when time
// moves on. Events at a clip's times are due where time_s was before, where it is now, and `turns` say. A time_s
// outside the clip counts as one that has just run there; a duration of 0 makes it 0, without a turn.
//
// Errors: bad_argument if time_s, speed, dt_s or duration_s is not finite, or duration_s is below 0; nothing is
// changed.
//
// Error: dt_s · speed is exact; to add it to the time rounds once, by at most 2⁻⁵³ (time_s + |dt_s · speed|) before and
// 2⁻⁵³ duration_s more where a loop passes its start backwards; finding the place of a time beyond an end is exact. So
// after 10⁷ steps of a clip of 10 s time is off by less than 2·10⁻⁸ s. Cost: a few operations; the logarithm of the
// turns where there are many. The same bits everywhere; thread-safe on different playbacks.
MARROW_API Status advance(Playback& playback, float duration_s, float dt_s);

// The time to sample: time_s as a float, which never goes beyond the clip.
inline float clip_time(const Playback& playback) {
  return static_cast<float>(playback.time_s);
}

// Whether a clip that plays once has reached the end towards which it runs; it stays true then. A clip at speed 0 runs
// towards none.
MARROW_API bool finished(const Playback& playback, float duration_s);

}  // namespace marrow
