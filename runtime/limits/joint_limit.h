// Limits of one rotation, for solvers.
#pragma once

#include "marrow/limits.h"
#include "math/wide.h"

namespace marrow {

// clamp_rotation(): q itself, bit for bit, if it is inside, has no length or is not finite.
WideRotation clamped(const JointLimit& limit, WideRotation q);

// The angle of the turn between two unit quaternions, 0 … π, within 1e-6.
float angle_between(WideRotation a, WideRotation b);

}  // namespace marrow
