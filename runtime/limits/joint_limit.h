// Limits of one rotation, for solvers.
#pragma once

#include "marrow/limits.h"
#include "math/quaternion.h"

namespace marrow {

// clamp_rotation(): q itself, bit for bit, if it is inside, has no length or is not finite.
Rotation clamped(const JointLimit& limit, const Rotation& q);

// The angle of the turn between two unit quaternions, 0 … π, within 1e-6.
float angle_between(const Rotation& a, const Rotation& b);

}  // namespace marrow
