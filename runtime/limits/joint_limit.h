// What functions on limits share: limits of one rotation, for solvers too.
#pragma once

#include "core/check.h"
#include "marrow/limits.h"
#include "math/wide.h"

namespace marrow {

// Of a call for a whole pose: the limits are there, and so are their joints.
BadCall check_joints(Span<const JointLimit> limits, Span<const SoaTransform> local);

// clamp_rotation(): q itself, bit for bit, if it is inside, has no length or is not finite.
WideRotation clamped(const JointLimit& limit, WideRotation q);

// The angle of the turn between two unit quaternions, 0 … π, within 1e-6.
float angle_between(WideRotation a, WideRotation b);

}  // namespace marrow
