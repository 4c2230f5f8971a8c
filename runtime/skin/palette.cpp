#include "marrow/palette.h"

#include "core/check.h"
#include "math/affine.h"
#include "skin/half_way.h"

namespace marrow {

Status build_palette(Span<const std::uint16_t> joints, Span<const Affine> bind, Span<const Affine> scene_from_joint,
                     Span<Affine> out, Span<const HalfJoint> half_joints) {
  MARROW_REQUIRE(bind.size >= joints.size);
  MARROW_REQUIRE(out.size >= joints.size + half_joints.size);
  for (const HalfJoint& h : half_joints) MARROW_REQUIRE(h.parent < joints.size && h.joint < joints.size);
  std::uint16_t last = 0;
  for (const std::uint16_t joint : joints) last = last < joint ? joint : last;
  MARROW_REQUIRE(joints.empty() || last < scene_from_joint.size);
  const auto product = [&](std::size_t i) {
    multiply(scene_from_joint.data[joints.data[i]], bind.data[i], out.data[i]);
  };
  std::size_t i = 0;
  for (; i + 4 <= joints.size; i += 4) {
    product(i);
    product(i + 1);
    product(i + 2);
    product(i + 3);
  }
  for (; i < joints.size; ++i) product(i);
  for (const HalfJoint& h : half_joints)
    out.data[i++] = half_way(out.data[h.parent], out.data[h.joint], bind.data[h.joint], h.share);
  return Status::ok;
}

Status build_palette(const Mesh& mesh, Span<const Affine> scene_from_joint, Span<Affine> out) {
  return build_palette({mesh.joints, mesh.joint_count}, {mesh.inverse_bind, mesh.joint_count}, scene_from_joint, out,
                       mesh.half_joints);
}

}  // namespace marrow
