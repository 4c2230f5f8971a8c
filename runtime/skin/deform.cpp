#include "skin/deform.h"

namespace marrow {

BadCall check_deform(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  const Geometry& g = mesh.geometry;
  const std::size_t slots = g.slot_count;
  const bool normals = !out.normals.empty(), tangents = !out.tangents.empty();
  MARROW_CHECK(holds(palette, mesh.palette_size()));
  MARROW_CHECK(g.joint_count <= mesh.palette_size() && "the mesh's own geometry");
  MARROW_CHECK(aligned(g.skin) && aligned(g.normals) && aligned(g.tangents));
  MARROW_CHECK(holds(out.positions, slots * 3));
  MARROW_CHECK(!normals || (g.normals != nullptr && holds(out.normals, slots * 3)));
  MARROW_CHECK(!tangents || (normals && g.tangents != nullptr && holds(out.tangents, slots * 4)));
  return {};
}

Directions directions_of(const SkinOutput& out) {
  if (out.normals.empty()) return Directions::none;
  if (out.normal_transform == NormalTransform::inverse_transpose) return Directions::exact;
  return out.tangents.empty() ? Directions::blended_normals : Directions::blended_tangents;
}

}  // namespace marrow
