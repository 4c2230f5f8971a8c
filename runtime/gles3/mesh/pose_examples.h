// Pose spaces on the GPU: a texture of changes vertex by vertex, and for each slot its first change there.
#pragma once

#include "gles3/mesh/gpu_mesh.h"
#include "gles3/palettes.h"

namespace marrow::gles3 {

// Bytes of scratch memory that make_examples() needs; 0 without examples.
std::size_t example_scratch_bytes(const Geometry& geometry);

// Fills in the pose-space members of `out`, whose layout must be filled in already. vertices: SSD's stream, to which
// each slot's row is written. Errors: unsupported (more than the smallest texture that GLES 3.0 allows can hold).
// Leaves the texture of the active unit at 0.
Status make_examples(const Api& api, const Geometry& geometry, float half_extent, std::byte* vertices,
                     Span<std::byte> scratch, GpuMesh& out);

// Room that pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and four
// examples. 0 without examples.
std::uint32_t distance_matrices(const Geometry& geometry);

// How far a pose is from the examples, in the order in which Deformer::psd reads it: otherwise as psd_distances().
// Upload it as palettes are, together with those of other characters: by upload_palettes() into a PaletteTexture of its
// own, on every path. palette: built with the bind matrices of prepare() or with the mesh's; the result is the same.
// out: distance_matrices(). Errors: bad_argument (no examples, a span too short). Cost: that of psd_distances().
Status pack_distances(const Geometry& geometry, Span<const Affine> palette, Span<Affine> out);

// Lets `program` deform by the mesh's examples and by uploaded distances: instance i takes those that begin at matrix
// first + GpuMesh::distances · i. The program must be in use and of Deformer::psd. Leaves `texture_unit` and the next
// one taken, the latter active. Errors: bad_argument (a mesh without examples, a program of another kind, distances
// that reach beyond what was uploaded).
Status bind_examples(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances, std::uint32_t first,
                     std::uint32_t texture_unit, const Program& program);

// The distances of the frame before, for a program with kMotion, after bind_examples(). kept and errors: as in
// bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
Status bind_previous_distances(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances,
                               std::uint32_t first, bool kept, std::uint32_t texture_unit, const Program& program);

}  // namespace marrow::gles3
