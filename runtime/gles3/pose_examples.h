// Pose spaces on the GPU: a texture of changes vertex by vertex, and for each slot its first change there.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Bytes of scratch memory that make_examples() needs; 0 without examples.
std::size_t example_scratch_bytes(const Geometry& geometry);

// Fills in the members of `out` that are a pose space's; its layout must be there. vertices: SSD's stream, where each
// slot's row is put. Errors: unsupported (more than the smallest texture that GLES 3.0 allows can hold). Leaves the
// texture of the active unit at 0.
Status make_examples(const Api& api, const Geometry& geometry, float half_extent, std::byte* vertices,
                     Span<std::byte> scratch, GpuMesh& out);

}  // namespace marrow::gles3
