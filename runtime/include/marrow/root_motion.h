// Root motion: how far a step of a clip moves the character, blends of such steps, and the character moved by them.
//
//   root_step(walk, before, playback, step);
//   world_from_model = move_root(world_from_model, step);
#pragma once

#include "marrow/api.h"
#include "marrow/clip_motion.h"
#include "marrow/playback.h"
#include "marrow/pose.h"
#include "marrow/status.h"

namespace marrow {

// A rigid motion: a rotation, then a translation.
struct RigidStep {
  float rotation[4] = {0, 0, 0, 1};  // unit quaternion x, y, z, w
  float translation[3] = {0, 0, 0};  // metres
};

// M(t), see RootKey: where the root is at time_s, in the model space of the clip's start. The identity for a motion
// without keys.
// Errors: bad_argument if the keys' span is null, time_s is no number, or what the keys give is not finite; nothing is
// written. Cost: a binary search and some dozen operations.
MARROW_API Status sample_root(const ClipMotion& motion, float time_s, RigidStep& out);

// How the root moved from `before` to `after`, which is `before` after one advance(): in the model space that the
// character had before the step. Any speed, mode and number of turns.
//
//   step = M(t0)⁻¹ · Lⁿ · M(t1) with L = M(duration)
// and n rounds of a loop; a playback that turns round, or plays once, has n = 0. So however time is cut into steps,
// their product is the same within rounding. In double precision; n rounds are off by less than 1e-6 m and 2⁻²⁴ of the
// way, n ≤ 10⁶. rotation: w ≥ 0.
// Errors: bad_argument as events_between(), and if the result is not finite; nothing is written. Cost: two
// sample_root(); in a loop the logarithm of n products.
MARROW_API Status root_step(const ClipMotion& motion, const Playback& before, const Playback& after, RigidStep& out);

// The step of a blend of clips: exp(Σ w log(step) / Σ w), with the logarithm of a rigid motion being its screw. A mean
// of a straight walk and a turn is then the same way at any frame rate, which it would not be of lengths and angles.
//
// steps, weights: one weight for each step, ≥ 0. If all are 0 the result is the identity. Steps are no longer than
// half a turn, and taken the shorter way round. Rotations need not be quite of unit length.
// Errors: bad_argument if a span is too short or null, a weight is below 0 or above 1e6, or the result is not finite;
// nothing is written. Cost: some 200 operations in double precision a step of weight above 0.
MARROW_API Status blend_root_steps(Span<const RigidStep> steps, Span<const float> weights, RigidStep& out);

// world_from_model after the step: world_from_model · step. Computed in double and rounded once, so a place some
// hundred metres from the origin drifts by centimetres a minute: RootPlace does not.
MARROW_API Affine move_root(const Affine& world_from_model, const RigidStep& step);

// Where a character stands in the world, in double precision: steps are added up for hours, and far from the origin.
struct RootPlace {
  double rotation[4] = {0, 0, 0, 1};  // unit quaternion x, y, z, w
  double translation[3] = {0, 0, 0};  // metres
};

// The place after the step. rotation: of unit length again.
MARROW_API RootPlace move_root(const RootPlace& place, const RigidStep& step);
// The place as a matrix, in floats. A game with a camera in double takes its place off before.
MARROW_API Affine world_from_model(const RootPlace& place);

}  // namespace marrow
