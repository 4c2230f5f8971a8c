// A limit applied to one rotation, for functions on limits and for solvers.
#pragma once

#include "core/check.h"
#include "marrow/limits.h"
#include "math/wide.h"

namespace marrow {

// Checks that the limits are there, and their joints in the pose.
BadCall check_joints(Span<const JointLimit> limits, Span<const SoaTransform> local);

// clamp_rotation(), for any q. One that is inside, has no length or is not finite comes back bit for bit.
WideRotation clamped(const JointLimit& limit, WideRotation q);

// The angle of the turn between two unit quaternions, 0 … π, within 1e-6.
float angle_between(WideRotation a, WideRotation b);

}  // namespace marrow
