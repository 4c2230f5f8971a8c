// Hair, clothes and things held in a hand, in files of their own: their joints follow the body's.
//
// `marrow cook hair.glb --skeleton body.mrw` gives an outfit the body's whole skeleton plus the joints that only the
// outfit has. Under each parent the outfit's own joints come after the body's. So an outfit may be posed, and may have
// springs, clips and masks as anything else. An outfit without joints of its own has the body's joints, number by
// number.
//
// make_outfit() and follow_body() of character.h do what is here for whole characters.
#pragma once

#include "marrow/api.h"
#include "marrow/clip_pack.h"
#include "marrow/file.h"

namespace marrow {

// Whether an outfit fits a body, and which joint of the body each of its joints is.
//
// body_joints: at least the outfit's joint_count. For each joint of the outfit it gets the body joint's number,
// ascending, or kNoJoint for a joint that only the outfit has. The outfit fits if it has all joints of the body, in
// their order and each below the same parent, and if every joint of its own has a parent. Rest poses may differ, as may
// the transforms above the roots: the same clothes fit a taller body. If all joints are the body's, body_joints[j] is
// j.
//
// misfits: as in bind_clips(). `joint` is one of the outfit; for `extra` it is one of the body that the outfit lacks;
// for `missing` it is a root that the body lacks. Errors: mismatch if it does not fit, and body_joints then holds
// nothing of use; bad_argument if an index is out of range or a span too short. Cost: a comparison of names a joint if
// it fits; else a search by name. No allocation. Thread-safe.
MARROW_API Status bind_outfit(const File& outfit, std::uint32_t skeleton, const File& body, std::uint32_t body_skeleton,
                              Span<std::uint16_t> body_joints, Span<JointMisfit> misfits = {},
                              std::size_t* misfit_count = nullptr);

// The outfit's model-space joints in the body's pose. The body's joints are copied; the outfit's own joints are placed
// by `local` below their parents. The result has the same bits as if local_to_model() had posed all of them.
//
// skeleton: the outfit's. body_joints: from bind_outfit(). local: at least skeleton.soa_size(); elements of the body's
// joints are not read. model_from_joint: at least skeleton.joint_count; does not overlap the body's.
// Errors: bad_argument if a span is too short, a joint out of range, or a root is not one of the body's.
// Cost: 48 bytes are copied a joint of the body; the others cost what local_to_model() does. Where body_joints[j] is
// always j, build_palette() and gles3::pose() may as well take the body's joints themselves, without a copy.
// Thread-safe on different outputs.
MARROW_API Status follow_body(const Skeleton& skeleton, Span<const std::uint16_t> body_joints,
                              Span<const Affine> body_model_from_joint, Span<const SoaTransform> local,
                              Span<Affine> model_from_joint);

}  // namespace marrow
