// Events: which of a clip's events a step of its playback met, and whether one goes on now.
//
//   const Playback before = playback;
//   advance(playback, motion.duration_s, dt_s);
//   events_between(motion, before, playback, first, hits, met);
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/api.h"
#include "marrow/clip_motion.h"
#include "marrow/playback.h"
#include "marrow/status.h"

namespace marrow {

// An event that a step met.
struct EventHit {
  std::uint32_t event = 0;  // of ClipMotion::events
  std::uint32_t count = 0;  // how often: more than once where the step is longer than the clip
};

// The events whose time_s the step from `before` to `after` met, in the order in which it met each first. `after` is
// `before` after one advance(), at any speed and in any mode.
//
// A step does not meet the moment that it starts from, and meets the one where it ends: forwards (before, after],
// backwards [after, before). So however time is cut into steps, each event is met exactly once each time that time goes
// over it. `first`: this is the playback's first step, which meets the moment that it starts from, too. In a loop the
// clip's end and its start are one moment: events at either are met together. A playback that turns round at an end
// meets the events there once. An event that lasts a whole round of a loop, as a foot that stands, does not begin
// again: only a first step meets it, once. After a jump of time_s by hand a step is a first one again.
//
// out: gets as many as it holds. met: how many events were met; more than out.size if some had no room. A motion has
// no more than motion.events.size of them, however long the step is. Counts stop where Playback::turns does.
//
// Errors: bad_argument if a span is null, the duration, or a time of the playbacks, is not finite or the duration below
// 0, after.time_s is outside the clip, or the playbacks are not of one mode; nothing is written. ping_pong takes the
// direction from after.speed, so dt_s must not have been below 0. Cost: a few comparisons an event, whatever the step.
// Thread-safe; no allocation.
MARROW_API Status events_between(const ClipMotion& motion, const Playback& before, const Playback& after, bool first,
                                 Span<EventHit> out, std::size_t& met);

// Whether time_s lies in an event's span, both of its ends included; of a clip of duration_s that loops, if the span
// goes beyond its end.
inline bool is_within(const ClipEvent& event, float time_s, float duration_s) {
  const float again_s = time_s + duration_s;
  return (event.time_s <= time_s && time_s <= event.until_s) || (event.time_s <= again_s && again_s <= event.until_s);
}

}  // namespace marrow
