// Morph targets on the GPU: a texture of changes, and for each slot its row in it.
#pragma once

#include "gles3/mesh/gpu_mesh.h"

namespace marrow::gles3 {

// The most morph targets that a vertex shader adds at a time: a quarter of the uniforms that GLES 3.0 promises.
inline constexpr std::uint32_t kMorphTargets = 64;

// Bytes of scratch memory that make_morphs() needs; 0 without targets.
std::size_t morph_scratch_bytes(const Geometry& geometry);

// Fills in the morph members of `out`; the others must be set already. Errors: unsupported (more than the smallest
// texture that GLES 3.0 allows can hold). Leaves the texture of the active unit and GL_ARRAY_BUFFER at 0.
Status make_morphs(const Api& api, const Geometry& geometry, float half_extent, Span<std::byte> scratch, GpuMesh& out);

// Sets the weights, one a target, by which `program` morphs; the program must be in use. It morphs as morph() does on
// the CPU, in animation space through the same blend as normals. If more than kMorphTargets weights are not 0, the
// targets that move most count. Leaves `texture_unit` active and the mesh's texture bound to it. Errors: bad_argument
// (a mesh without targets, a program without kMorphs, too few weights, one that is not finite).
Status set_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                  std::uint32_t texture_unit, const Program& program);

// The weights of the frame before, for a program with kMotion, after set_morphs(). Errors: as there.
Status set_previous_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                           const Program& program);

}  // namespace marrow::gles3
