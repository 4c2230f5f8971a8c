// What a kernel of inverse kinematics found, put into a pose.
#pragma once

#include "marrow/file.h"
#include "math/joint.h"

namespace marrow {

// The kernels know the axes of a matrix, which hide whether a joint mirrors itself by its own scale: there the turn
// goes the other way about the axes that are mirrored an odd number of times.
inline void turn_joint(Span<SoaTransform> local, std::size_t joint, const float (&turn)[4]) {
  const Vector3 s = scale_of(local, joint);
  const bool x = s.x < 0, y = s.y < 0, z = s.z < 0;
  const Rotation own = {y != z ? -turn[0] : turn[0], x != z ? -turn[1] : turn[1], x != y ? -turn[2] : turn[2], turn[3]};
  set_rotation(local, joint, normalised(rotation_of(local, joint) * own));
}

// Whether `joint` is below `above`, at any depth. Both are joints of the skeleton.
inline bool hangs_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t above) {
  while (joint > above && joint >= skeleton.root_count) joint = skeleton.parents[joint];
  return joint == above;
}

}  // namespace marrow
