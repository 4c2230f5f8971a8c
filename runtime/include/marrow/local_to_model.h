// Local to model: local transforms → one model-space matrix a joint. And a pose that has both.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// A skeleton's pose in both forms. What changes one form keeps the other alike. The spans are views: functions that
// take a const Pose write through them.
struct Pose {
  Skeleton skeleton = {};              // of a file
  Span<SoaTransform> local = {};       // at least skeleton.soa_size()
  Span<Affine> model_from_joint = {};  // at least skeleton.joint_count
};

// model_from_joint = model_from_root · Π parent_from_joint, from the root down. model_from_root is the fixed transform
// that the source has above the skeleton, so the matrices are in the source's own space.
//
// local: at least skeleton.soa_size(); out: at least skeleton.joint_count; they do not overlap.
// Errors: bad_argument if a span is too short.
// Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint: 70 instructions on x86-64, 49
// on AArch64. Thread-safe on different outputs.
MARROW_API Status local_to_model(const Skeleton& skeleton, Span<const SoaTransform> local, Span<Affine> out);

// A level of detail: the same for the first `joint_count` joints only, to the same bits. Joints are breadth-first, so
// the parents of these joints are among them. All other matrices are left as they are.
//
// local: at least soa_count(joint_count); out: at least joint_count. Errors: bad_argument also if there are fewer
// joints.
MARROW_API Status local_to_model_first(const Skeleton& skeleton, Span<const SoaTransform> local,
                                       std::uint32_t joint_count, Span<Affine> out);

// The same for `joint` and its descendants only, after a change of their local transforms, say by inverse kinematics.
// `out` holds the matrices of the whole skeleton; all others keep their bits.
//
// local: at least skeleton.soa_size(); out: at least skeleton.joint_count. Errors: bad_argument also if there is no
// such joint. Cost: that of local_to_model for these joints, where a group of four that a generation covers only in
// part costs as much as a whole one; and one comparison for each other joint from `joint` to the last generation.
MARROW_API Status local_to_model_below(const Skeleton& skeleton, Span<const SoaTransform> local, std::uint32_t joint,
                                       Span<Affine> out);

}  // namespace marrow
