// Stage 2, sample: a clip at a time → local transforms of every joint.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Evaluates `clip` at `time_s`, clamped to each track's first and last key, as glTF 2.0 defines its interpolations:
// STEP, LINEAR (spherical along the shortest arc for rotations) and CUBICSPLINE (Hermite, rotations normalised). Coded
// tracks are blended between their two nearest frames, rotations on the sphere; they keep the cooker's --clip-error.
//
// out: at least skeleton.soa_size() elements, caller's memory; joints that the clip leaves alone get their rest pose.
// Errors: bad_argument if `out` is too short, the clip belongs to a skeleton with other joints, or time_s is not a
// number. Rotations differ from exact spherical interpolation by at most 1e-6 rad plus float rounding. Cost: a binary
// search a distinct key-time list and a few dozen operations a track, wherever time_s is. Stateless; thread-safe on
// different outputs.
Status sample(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out);

}  // namespace marrow
