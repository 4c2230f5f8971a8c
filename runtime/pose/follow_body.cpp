// The joints of an outfit in its body's pose.
#include "core/check.h"
#include "core/zone.h"
#include "marrow/outfit.h"
#include "pose/joint_range.h"

namespace marrow {

Status follow_body(const Skeleton& skeleton, Span<const std::uint16_t> body_joints,
                   Span<const Affine> body_model_from_joint, Span<const SoaTransform> local,
                   Span<Affine> model_from_joint) {
  MARROW_ZONE;
  const std::uint32_t count = skeleton.joint_count;
  MARROW_REQUIRE(holds(body_joints, count));
  MARROW_REQUIRE(holds(body_model_from_joint));
  MARROW_REQUIRE(holds(local, skeleton.soa_size()));
  MARROW_REQUIRE(holds(model_from_joint, count));
  for (std::uint32_t j = 0; j < count; ++j)
    MARROW_REQUIRE(body_joints[j] == kNoJoint ? j >= skeleton.root_count : body_joints[j] < body_model_from_joint.size);
  for (std::uint32_t j = 0; j < count;) {
    if (body_joints[j] != kNoJoint) {
      model_from_joint[j] = body_model_from_joint[body_joints[j]];
      ++j;
      continue;
    }
    std::uint32_t end = j + 1;
    while (end < count && body_joints[end] == kNoJoint) ++end;
    transform_joints(skeleton, local.data, j, end, model_from_joint.data);
    j = end;
  }
  return Status::ok;
}

}  // namespace marrow
