// Stage 5, skin on the CPU: bind vertices and a palette → deformed vertices.
//
// Every deformer writes whole slots (Geometry::slot_count, padding included), so that indices can be used as they are.
// Positions are in the palette's space (scene space after local_to_model). All are thread-safe on different outputs.
#pragma once

#include "marrow/file.h"

namespace marrow {

struct SkinOutput {
  Span<float> positions;  // 3 a slot; required
  // 3 a slot, unit; leave empty to skip. The bind normal goes through the inverse transpose of the blended matrix (its
  // cofactors), which is exact for any blend that can be inverted, mirrored or unevenly scaled ones too.
  Span<float> normals;
  // 4 a slot: xyz unit, through the blended matrix; w the handedness, turned where the blend mirrors. Needs normals.
  // Leave empty to skip.
  Span<float> tangents;
};

// Each vertex follows the joint with its largest weight.
//   position = M_j (v, 1)
// palette: mesh.joint_count entries. Errors, here and below: bad_argument if a span is too short, or normals or
// tangents are asked of a mesh without.
Status skin_rigid(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);

// Skeletal subspace deformation, also called linear blend skinning.
//   position = (Σ_j w_j M_j) (v, 1)
// Cost: 12 multiply-adds an influence but the last, 9 for the position, 36 for the normal.
Status skin_ssd(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);

// How many floats as_coordinates() writes: 4 an influence, four vertices a block.
std::size_t as_coordinate_count(const Geometry& geometry);

// Animation-space coordinates of every slot, from lift and residual: q_j = (w_j v + d_j, w_j + δ_j), Σ_j (q_j)_w = 1.
// In the notation of Merry, Marais and Gain (ACM TOG 25(4), 2006) p_j = B_j⁻¹ q_j; B_j⁻¹ stands in the palette here.
// out: as_coordinate_count() floats, a block: k times x[4] y[4] z[4] w[4]. Done once a mesh, not a frame.
Status as_coordinates(const Geometry& geometry, Span<float> out);

// Animation space.
//   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
// Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
// coordinates: from as_coordinates() of this geometry.
// Cost: 12 multiply-adds an influence; 9 more an influence, and 27, with normals.
Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out);

}  // namespace marrow
