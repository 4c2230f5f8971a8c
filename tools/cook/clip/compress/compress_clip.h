// A clip of keys → the same clip in coded segments, or in rounded keys, within a promised error.
#pragma once

#include <span>

#include "cook/clip/measure/clip_measure.h"
#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

// The nearest multiple of the largest power of two that keeps it within the slack; the value itself where there is
// none.
float rounded_within(double slack, float value);

// By how much a value is off at most, for each unit that a tangent of such keys is off.
double tangent_lever(std::span<const float> times_s);

// Rounds each track's values to multiples of a power of two, so coarse that the track alone strays by about `share` of
// the promise. Tangents have a power of their own, by the longest time between two keys. Rotations of LINEAR and STEP
// tracks stay as they are, since they must be unit quaternions.
BuiltClip with_rounded_keys(const BuiltClip& clip, const Rig& rig, const Promise& promise, double share);

// Replaces the tracks of `clip` by coded ones where that keeps the promise and saves bytes; STEP tracks stay as they
// are. The promise is checked with the runtime's own decoder, in model space through the whole hierarchy, against the
// source curves at every frame, the quarters between, every key and both sides of what jumps, of joints' shells and of
// `hung`'s vertices; clip.error says the largest errors found. channels: by which the clip weighs morph targets; its
// own are none yet. Deterministic. Method: the cooker's own; the search for bit rates against the error of the whole
// hierarchy follows Frechette's "Compression by object-space error" in the Animation Compression Library.
void compress_clip(BuiltClip& clip, const BuiltSkeleton& skeleton, const Rig& rig, const Promise& promise,
                   const Hung& hung, Effort effort, const BuiltClip& channels = {});

}  // namespace marrow::cook
