// What a kernel of inverse kinematics found, put into a pose.
#pragma once

#include "core/check.h"
#include "marrow/file.h"
#include "math/joint.h"

namespace marrow {

// A quaternion of any length; the identity of one that is too short, or not finite.
[[gnu::noinline]] inline void set_direction(Span<SoaTransform> pose, std::size_t joint, WideRotation q) {
  set_rotation(pose, joint, normalised(q));
}

// The kernels know the axes of a matrix, which hide whether a joint mirrors itself by its own scale: there the turn
// goes the other way about the axes that are mirrored an odd number of times.
inline void turn_joint(Span<SoaTransform> local, std::size_t joint, const float (&turn)[4]) {
  const Vector3 s = scale_of(local, joint);
  const f32x4 mirrored = flip(lanes(s.y, s.z, s.x, 1), lanes(s.z, s.x, s.y, 1));
  set_direction(local, joint, wide_rotation_of(local, joint) * WideRotation{flip(load(turn), mirrored)});
}

// Whether `joint` is below `above`, at any depth. Both are joints of the skeleton.
inline bool hangs_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t above) {
  while (joint > above && joint >= skeleton.root_count) joint = skeleton.parents[joint];
  return joint == above;
}

// A pose and its matrices are there, and of the joints each is below the one before it.
[[gnu::noinline]] inline BadCall check_chain(const Skeleton& skeleton, Span<const SoaTransform> local,
                                             Span<const Affine> scene_from_joint, Span<const std::uint32_t> joints) {
  MARROW_CHECK(holds(local, skeleton.soa_size()));
  MARROW_CHECK(holds(scene_from_joint, skeleton.joint_count));
  MARROW_CHECK(holds(joints) && !joints.empty() && joints[0] < skeleton.joint_count);
  for (std::size_t i = 1; i < joints.size; ++i) {
    MARROW_CHECK(joints[i - 1] < joints[i] && joints[i] < skeleton.joint_count);
    MARROW_CHECK(hangs_below(skeleton, joints[i], joints[i - 1]));
  }
  return {};
}

}  // namespace marrow
