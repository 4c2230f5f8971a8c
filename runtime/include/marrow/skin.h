// Skin on the CPU: bind vertices and a palette → deformed vertices.
//
// Every deformer writes all Geometry::slot_count slots, padding included, so that the geometry's indices can be used as
// they are. Positions are in the palette's space (model space after local_to_model). All are thread-safe on different
// outputs.
//
// Costs are CPU instructions for each vertex with four influences, in runs of about 150 vertices: first x86-64 (SSE2),
// then AArch64, by g++ 12 -O3.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// How normals and tangents of the bind pose are deformed. M is the 3×3 part of the vertex's blended matrix.
enum class NormalTransform : std::uint8_t {
  // Normals through the inverse transpose of M (its cofactors), tangents through M, both unit: exact for any blend that
  // can be inverted, mirrored or unevenly scaled ones too.
  inverse_transpose,
  // Both through M, not normalised: half the time, for shaders that normalise anyway. Directions are right where M is a
  // rotation, a mirror or an even scale; a blend of rotations is not quite one of these. On real clips normals stray by
  // 0.8° on average, by up to 58° inside sharp bends, and come as short as 0.27 (docs/benchmarks.md). Tangents are
  // those of inverse_transpose, except for their length.
  blended_matrix,
};

// Where skinned vertices go: the caller's memory, slot after slot.
struct SkinOutput {
  Span<float> positions = {};  // 3 a slot; required
  Span<float> normals = {};    // 3 a slot; leave empty to skip
  // 4 a slot: xyz, then the handedness, which changes sign where the blend mirrors. With blended_matrix, skin_ssd() and
  // skin_as() take that from the determinant of the run's last joint instead of the blend's: the two differ only at a
  // vertex that follows both mirrored and unmirrored joints. Needs normals. Leave empty to skip.
  Span<float> tangents = {};
  NormalTransform normal_transform = NormalTransform::inverse_transpose;  // of tangents, too
};

// Each vertex follows the joint with its largest weight.
//   position = M_j (v, 1)
// palette: mesh.palette_size() entries. Errors, here and below: bad_argument if a span is too short, if the geometry
// refers to palette entries that the mesh does not have (then it is another mesh's), if normals or tangents are asked
// of a mesh without them, or if the geometry's floats do not stand on 16-byte boundaries.
// Cost: positions 50 / 32; with exact normals 78 / 49.
MARROW_API Status skin_rigid(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);

// Skeletal subspace deformation, also called linear blend skinning.
//   position = (Σ_j w_j M_j) (v, 1)
// Cost: positions 38 / 29. Through the blended matrix: with normals 47 / 34, with tangents too 59 / 42. Through the
// inverse transpose: 66 / 47 and 83 / 56. In multiply-adds that is 12 for each influence except the last, 9 for the
// position, and 9 for each normal or tangent through the matrix. A normal through the inverse transpose takes 27
// multiplications, a square root and a division.
MARROW_API Status skin_ssd(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);

// How many floats as_coordinates() writes: 3 a slot, and 4 more for each of its influences except the last.
MARROW_API std::size_t as_coordinate_count(const Geometry& geometry);

// Animation-space coordinates of every slot: q_j = (w_j v + d_j, w_j + δ_j), with Σ_j (q_j)_w = 1. (w_j v, w_j) is the
// lift of SSD's weights; (d_j, δ_j) is Geometry::as_residual. In the notation of Merry, Marais and Gain (ACM TOG 25(4),
// 2006) p_j = B_j⁻¹ q_j, with B_j⁻¹ the joint's inverse bind matrix; here B_j⁻¹ is part of the palette's M_j.
//
// As with the weights of SSD, the last influence is not stored, since it is what the others leave: a block holds the
// sum Σ_j q_j as x[4] y[4] z[4] (its w is 1), then x[4] y[4] z[4] w[4] of each q_j but the last.
// out: as_coordinate_count() floats. Done once a mesh, not a frame.
MARROW_API Status as_coordinates(const Geometry& geometry, Span<float> out);

// A mesh in animation space, for as_tangents().
struct AsPart {
  const Mesh* mesh = nullptr;          // cooked with animation space
  Span<const float> coordinates = {};  // from as_coordinates()
  Span<float> tangents = {};           // as_tangent_count() floats, to be written
};

// How many floats as_tangents() writes of a mesh: twice as_coordinate_count().
MARROW_API std::size_t as_tangent_count(const Geometry& geometry);

// Bytes of scratch memory that as_tangents() wants: about 32 a slot and 4 an index.
MARROW_API std::size_t as_tangent_scratch_bytes(Span<const AsPart> parts);

// Two tangents of the surface at every slot as animation-space vectors, as in Merry, Marais and Gain:
//   t = Σ_k c_k (p_k - p) over the vertex's neighbours k, so t = Σ_j M_j τ_j with τ_j = Σ_k c_k (q_kj - q_j),
//   Σ_j (τ_j)_w = 0
// Each is the derivative of the surface along one of two directions: the mean over the triangles round the vertex,
// weighted by area. In the bind pose, unless residuals change that, the two are perpendicular unit vectors: t₀ × t₁ is
// the mesh's normal, and t₀ points along its tangent if it has one. Where the triangles' own derivative in the bind
// pose is not that unit vector, the difference goes through the blended matrix; it is all of t if the triangles have no
// area.
//
// A neighbour may follow a palette entry that the vertex does not follow. It is replaced by the linear combination of
// the vertex's own entries that blends the same joints at the same shares, or comes closest. Before that, a joint that
// none of the vertex's entries blends is replaced by the vertex's joint that the neighbour follows most.
//
// parts: the meshes that make up a surface, such as the primitives of one mesh of the source. Slots in one place, with
// the same weights and normals less than 25° apart, are one vertex, whichever part they are in; so seams do not show.
// scratch: as_tangent_scratch_bytes(), on a 4-byte boundary, free again afterwards. Errors: bad_argument if a mesh has
// no normals or a span is too short. Call it once, not every frame: it takes about 11 000 instructions for each vertex,
// and 23 000 where helpers are involved.
MARROW_API Status as_tangents(Span<const AsPart> parts, Span<std::byte> scratch);

// Animation space.
//   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
//            = M_last Σ_j q_j + Σ_{j<last} (M_j - M_last) q_j
// Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
// coordinates: from as_coordinates() of this geometry.
// Cost: positions 40 / 31. Through the blended matrix: with normals 73 / 56, with tangents too 85 / 62. Through the
// inverse transpose: 92 / 69 and 108 / 77. In multiply-adds that is 12 for each influence except the last and 9 for the
// sum; with normals 9 more for each influence except the last.
//
// tangents: from as_tangents() of this geometry, or empty. With them, normals are those of the deformed surface itself,
// t₀' × t₁' with t' = Σ_j M_j τ_j, negated where the run's last joint mirrors. Tangents are t₀', whose handedness
// changes sign there. Both are unit vectors, whatever out.normal_transform says. `tangents` are of the surface without
// morph targets. Cost, x86-64: 140, and with tangents 151.
MARROW_API Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette,
                          const SkinOutput& out, Span<const float> tangents = {});

// Multi-weight enveloping: Wang and Phillips, "Multi-weight enveloping: least-squares approximation techniques for skin
// animation", SCA 2002. Twelve weights an influence, one for each element of its matrix:
//   position = R Σ_j (Ω_j ∘ R⁻¹ M_j) (v, 1)        Ω_j = w_j + Geometry::mwe_residual, ∘ element by element
// Weights of single elements depend on the frame in which matrices are given. That frame, R, is taken from the palette
// entry Geometry::mwe_root: the rotation that Gram-Schmidt makes of its matrix's first two columns, and its
// translation. So the result moves with the character. Normals and tangents go through the 3×3 part of the blend, R Σ_j
// Ω_j ∘ R⁻¹ M_j, which is SSD's where the residual is zero. With blended_matrix this blend decides whether tangents are
// mirrored.
//
// Errors: also bad_argument for a geometry without mwe_residual. Cost, x86-64: positions 82; with normals through the
// blended matrix 110, through the inverse transpose 127. It reads 192 bytes of residual a block and influence, so with
// four influences nine times as much as SSD.
MARROW_API Status skin_mwe(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);

// How many floats psd_distances() writes: for each palette entry one for each example and one for the bind pose; 0
// without examples.
MARROW_API std::size_t psd_distance_count(const Geometry& geometry);

// How far a pose is from the examples, joint by joint; skin_psd() takes the mean for each vertex by its weights. For
// palette entry j and example k it is D_jk = 1 - (q_j · q_jk)² = sin²(half the angle between), with q_j the rotation of
// M_j relative to its parent's, rotations as in skin_mwe(); 0 for an entry without a parent.
// out, for each palette entry j: -D_jk / 2σ² for each example k, then the same for the bind pose in place of an
// example. Call it once for each mesh and frame. Errors: bad_argument if a span is too short.
// Cost: 34 instructions a palette entry and example, x86-64.
MARROW_API Status psd_distances(const Geometry& geometry, Span<const Affine> palette, Span<float> out);

// Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000, with distances
// weighted for each vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
//   position = (Σ_j w_j M_j) (v + (1 - φ_bind) Σ_k φ_k d_k, 1)        d_k: Geometry::pose_space
//   φ_k = exp(-Σ_j w_j D_jk / 2σ²)
// The factor 1 - φ_bind makes the deltas vanish in the bind pose. Normals and tangents go through the blend, as in SSD.
// distances: from psd_distances() of this geometry and palette. Errors: also bad_argument if they are too few. A
// geometry without examples is deformed as by skin_ssd().
// Cost, x86-64: positions 49, with normals through the blended matrix 61, through the inverse transpose 74; and 30 more
// a vertex for each example that moves the vertex's block of four.
MARROW_API Status skin_psd(const Mesh& mesh, Span<const float> distances, Span<const Affine> palette,
                           const SkinOutput& out);

}  // namespace marrow
