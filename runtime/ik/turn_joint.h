// Turns found by the kernels are put into a pose here, and calls with poses are checked.
#pragma once

#include "core/check.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"
#include "math/joint.h"
#include "pose/hierarchy.h"

namespace marrow {

// Sets a joint's rotation to a quaternion of any length; to the identity where that is too short or not finite.
[[gnu::noinline]] inline void set_direction(Span<SoaTransform> pose, std::size_t joint, WideRotation q) {
  set_rotation(pose, joint, normalised(q));
}

// Multiplies a kernel's turn onto a joint's rotation. The kernel saw a matrix, which does not tell a joint's own
// mirroring scale from its rotation: a turn's x changes sign if just one of the scale's y and z is negative, and so on.
inline void turn_joint(Span<SoaTransform> local, std::size_t joint, const float (&turn)[4]) {
  const Vector3 s = scale_of(local, joint);
  const f32x4 next = rotated_xyz(lanes(s.x, s.y, s.z, 1)), mirrored = flip(next, rotated_xyz(next));
  set_direction(local, joint, wide_rotation_of(local, joint) * WideRotation{flip(load(turn), mirrored)});
}

// The pose and its matrices are there.
[[gnu::noinline]] inline BadCall check_pose(const Pose& pose) {
  MARROW_CHECK(holds(pose.local, pose.skeleton.soa_size()));
  MARROW_CHECK(holds(pose.model_from_joint, pose.skeleton.joint_count));
  return {};
}

// So are the joints, each below the one before it.
[[gnu::noinline]] inline BadCall check_chain(const Pose& pose, Span<const std::uint32_t> joints) {
  if (const BadCall bad = check_pose(pose)) return bad;
  MARROW_CHECK(holds(joints) && !joints.empty() && joints[0] < pose.skeleton.joint_count);
  for (std::size_t i = 1; i < joints.size; ++i) {
    MARROW_CHECK(joints[i - 1] < joints[i] && joints[i] < pose.skeleton.joint_count);
    MARROW_CHECK(hangs_below(pose.skeleton, joints[i], joints[i - 1]));
  }
  return {};
}

// The map of what is above a joint: model_from_parent.
inline const Affine& map_above(const Pose& pose, std::uint32_t joint) {
  const Skeleton& skeleton = pose.skeleton;
  return joint < skeleton.root_count ? skeleton.model_from_root[joint] : pose.model_from_joint[skeleton.parents[joint]];
}

// Updates the matrices of a joint that has turned and of all below it.
[[gnu::noinline]] inline void update_below(const Pose& pose, std::uint32_t joint) {
  (void)local_to_model_below(pose.skeleton, pose.local, joint, pose.model_from_joint);
}

}  // namespace marrow
