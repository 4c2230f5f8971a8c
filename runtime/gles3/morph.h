// Morph targets on the GPU: a texture of changes, and for each slot its row in it.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Bytes of scratch memory that make_morphs() needs; 0 without targets.
std::size_t morph_scratch_bytes(const Geometry& geometry);

// Fills in the morph members of `out`; the others must be set already. Errors: unsupported (more than the smallest
// texture that GLES 3.0 allows can hold). Leaves the texture of the active unit and GL_ARRAY_BUFFER at 0.
Status make_morphs(const Api& api, const Geometry& geometry, float half_extent, Span<std::byte> scratch, GpuMesh& out);

}  // namespace marrow::gles3
