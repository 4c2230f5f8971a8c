// Stage 3, local to model: local transforms → one scene-space matrix a joint.
#pragma once

#include "marrow/file.h"

namespace marrow {

// scene_from_joint = scene_from_root · Π parent_from_joint, from the root down; scene_from_root is what the source has
// above the skeleton and never moves, so the matrices are in the source's scene space.
//
// local: at least skeleton.soa_size(); out: at least skeleton.joint_count; they do not overlap.
// Errors: bad_argument if a span is too short.
// Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint. Thread-safe on different
// outputs.
Status local_to_model(const Skeleton& skeleton, Span<const SoaTransform> local, Span<Affine> out);

}  // namespace marrow
