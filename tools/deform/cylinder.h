// The cylinder that deformers are commonly shown on.
#pragma once

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Radius 1, length 10 along x, 40 vertices round, 50 along, capped; joint 0 holds x < 0, joint 1 turns about the
// middle. Weights are a quintic ramp over ±1.5 radii.
SkinnedMesh cylinder();

// Joint 1 turned by Rz(bend) · Rx(twist).
Pose cylinder_pose(double bend_rad, double twist_rad);

}  // namespace marrow::deform
