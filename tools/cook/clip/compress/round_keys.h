// Keys that stay as keys, in steps as coarse as the promise allows: packed files have them in fewer bytes.
#pragma once

#include <span>

#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// The nearest whole number of the largest power of two that keeps it within the slack; itself where there is none.
float rounded_within(double slack, float value);

// What a tangent of such keys adds to a value at most, for each unit that it is off.
double tangent_lever(std::span<const float> times_s);

// The tracks' values as whole numbers of a power of two each, near which a track alone strays by about `share` of the
// promise; tangents of another, by the longest time between two keys. Rotations of LINEAR and STEP tracks stay as they
// are, since they must be unit quaternions.
BuiltClip with_rounded_keys(const BuiltClip& clip, const Rig& rig, const Promise& promise, double share);

}  // namespace marrow::cook
