#include "core/check.h"
#include "marrow/pose.h"

namespace marrow {

Status get_joint(Span<const SoaTransform> local, std::uint32_t joint, JointTransform& out) {
  MARROW_REQUIRE(holds(local) && joint / 4 < local.size);
  const SoaTransform& group = local[joint / 4];
  const std::uint32_t lane = joint % 4;
  for (int i = 0; i < 3; ++i) out.translation[i] = group.translation[i][lane];
  for (int i = 0; i < 4; ++i) out.rotation[i] = group.rotation[i][lane];
  for (int i = 0; i < 3; ++i) out.scale[i] = group.scale[i][lane];
  return Status::ok;
}

Status set_joint(Span<SoaTransform> local, std::uint32_t joint, const JointTransform& transform) {
  MARROW_REQUIRE(holds(local) && joint / 4 < local.size);
  SoaTransform& group = local[joint / 4];
  const std::uint32_t lane = joint % 4;
  for (int i = 0; i < 3; ++i) group.translation[i][lane] = transform.translation[i];
  for (int i = 0; i < 4; ++i) group.rotation[i][lane] = transform.rotation[i];
  for (int i = 0; i < 3; ++i) group.scale[i][lane] = transform.scale[i];
  return Status::ok;
}

}  // namespace marrow
