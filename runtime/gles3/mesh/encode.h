// Bind vertices as floats → the compact attributes of GpuMesh. Pure arithmetic; prepare.cpp uploads what this writes.
#pragma once

#include "gles3/mesh/gpu_mesh.h"

namespace marrow::gles3 {

// How positions and coordinates of a mesh are stored: p̂ = (v - centre) / half_extent, |p̂| ≤ 1.
struct Quantisation {
  float centre[3] = {};
  float half_extent = 1;
  std::int32_t coordinate_one = 32767;  // integer that stands for 1 in animation-space coordinates
};

// Joints stand in groups of four, weights in groups of two, so that all is aligned to four bytes.
inline std::uint32_t joint_places(const VertexLayout& layout) {
  return (layout.influences + 3) / 4 * 4;
}
inline std::uint32_t weight_places(const VertexLayout& layout) {
  return (layout.influences + 1) / 2 * 2;
}
// One pass over the uvs when the mesh has any. as_tangents: whether there are any. psd: as PrepareOptions::psd.
VertexLayout make_layout(const Mesh& mesh, bool as_tangents, bool psd);

// Box and room for residuals, see prepare(). One pass over the vertices when the mesh has residuals.
Quantisation make_quantisation(const Geometry& geometry);

// Each writes slot_count × stride bytes. Within a vertex the influence with the largest weight comes first; unused ones
// have weight 0 and repeat its joint. The row of examples is left as it is.
void encode_ssd(const Geometry& geometry, const VertexLayout& layout, const Quantisation& quantisation, std::byte* out);
// tangents: from as_tangents(), where the layout has them. whole_coordinates: as MARROW_WORDS 2.
void encode_as(const Geometry& geometry, const VertexLayout& layout, const Quantisation& quantisation,
               const float* tangents, bool whole_coordinates, std::byte* out);
void encode_surface(const Geometry& geometry, const VertexLayout& layout, std::byte* out);

// Rounds values to integers (in units of 1/total) so that they sum to `total` exactly: floors, then one more for the
// largest remainders. The values sum to 1 but for rounding. count ≤ kMaxInfluences.
void quantise_sum(const float* values, std::uint32_t count, std::int32_t total, std::int32_t* out);

// A unit vector on the octahedron, both coordinates in [-1, 1] (Cigolle et al., JCGT 3(2), 2014).
void to_octahedron(const float unit[3], float out[2]);

}  // namespace marrow::gles3
