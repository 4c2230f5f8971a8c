// Hair, clothes and what a hand holds, in files of their own: their joints stand where the body's stand.
//
// `marrow cook hair.glb --skeleton body.mrw` gives an outfit the body's whole skeleton, and among it the joints that
// only the outfit has: of each parent behind its children of the body. So an outfit may be posed, may have springs,
// clips and masks as anything else, and where it has no joints of its own, its joints are the body's, number by number.
//
// make_outfit() and follow_body() of character.h do what is here for whole characters.
#pragma once

#include "marrow/api.h"
#include "marrow/clip_pack.h"
#include "marrow/file.h"

namespace marrow {

// Whether an outfit fits a body, and which joint of the body each of its joints is.
//
// body_joints: at least the outfit's joint_count; gets the number of the body's joint, ascending, or kNoJoint for what
// only the outfit has. It fits if all joints of the body are there, in their order and each below the same parent, and
// if each joint of its own hangs on another joint. Rest poses may differ, as may what stands above the roots: the same
// clothes fit a taller body. Where all joints are the body's own, body_joints[j] is j.
//
// misfits: as of bind_clips(), where `joint` is of the outfit and `extra` one that the outfit lacks, of the body;
// `missing`: a root that the body lacks.
// Errors: mismatch if it does not fit, where body_joints holds nothing of use; bad_argument if an index is out of range
// or a span too short. Cost: a comparison of names a joint if it fits; else a search by name. No allocation.
// Thread-safe.
MARROW_API Status bind_outfit(const File& outfit, std::uint32_t skeleton, const File& body, std::uint32_t body_skeleton,
                              Span<std::uint16_t> body_joints, Span<JointMisfit> misfits = {},
                              std::size_t* misfit_count = nullptr);

// The outfit's model-space joints in the body's pose: joints of the body are copied, the outfit's own stand at `local`
// below their parents. Poses are the same bits as if local_to_model() had posed them all.
//
// skeleton: the outfit's. body_joints: as bind_outfit() gives it. local: at least skeleton.soa_size(), of which joints
// of the body are not read. model_from_joint: at least skeleton.joint_count; does not overlap the body's.
// Errors: bad_argument if a span is too short, a joint out of range, or a root none of the body's.
// Cost: 48 bytes are copied a joint of the body; the others cost what local_to_model() does. Where body_joints[j] is
// always j, build_palette() and gles3::pose() may as well take the body's joints themselves, without a copy.
// Thread-safe on different outputs.
MARROW_API Status follow_body(const Skeleton& skeleton, Span<const std::uint16_t> body_joints,
                              Span<const Affine> body_model_from_joint, Span<const SoaTransform> local,
                              Span<Affine> model_from_joint);

}  // namespace marrow
