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

// The state of a playing clip: plain numbers that may be set, copied and stored at will. To play a clip backwards once,
// start with time_s = its duration and a speed below 0.
struct Playback {
  double time_s = 0;               // in the clip
  float speed = 1;                 // seconds of the clip a second; 0 pauses, below 0 runs backwards
  PlayMode mode = PlayMode::loop;  // what happens at the ends
  bool returning = false;          // ping_pong: on the way back, so time runs against speed
  // Turns in the last advance(). loop: how often time went from the clip's end to its start, minus how often from start
  // to end. ping_pong: how often time turned. once: 0. Stops at ±2147483647.
  std::int32_t turns = 0;
};
static_assert(sizeof(Playback) <= 128);

// Moves `playback` on by dt_s seconds times its speed, in a clip of `duration_s`. Time beyond an end is carried over,
// however many times it passes: neither a loop nor a turn loses time or shows any twice. Afterwards time_s is in 0 …
// duration_s, and in a loop below duration_s. A time exactly at an end passes it, or turns there, only when time moves
// on. To find the events that are due, compare time_s before and after, and read `turns`. A time_s outside the clip is
// treated as if time had just run there. In a clip of duration 0, time_s becomes 0, without a turn.
//
// Errors: bad_argument if time_s, speed, dt_s or duration_s is not finite, or duration_s is below 0; nothing is
// changed.
//
// Rounding: dt_s · speed is exact. Adding it to the time rounds once, by at most 2⁻⁵³ (time_s + |dt_s · speed|), with
// time_s as it was before, and by 2⁻⁵³ duration_s more where a loop passes its start backwards. Wrapping a time beyond
// an end is exact. So after 10⁷ steps of a clip of 10 s time is off by less than 2·10⁻⁸ s. Cost: a few operations; the
// logarithm of the turns where there are many. The same bits everywhere; thread-safe on different playbacks.
MARROW_API Status advance(Playback& playback, float duration_s, float dt_s);

// The time to sample: time_s as a float, which never goes beyond the clip.
inline float clip_time(const Playback& playback) {
  return static_cast<float>(playback.time_s);
}

// Whether a clip that plays once has reached the end that it runs towards; it stays true while time runs on. At speed 0
// it runs towards no end.
MARROW_API bool finished(const Playback& playback, float duration_s);

}  // namespace marrow
