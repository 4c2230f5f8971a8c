// Pose spaces on the GPU: a texture of changes vertex by vertex, and for each slot its first change there.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Bytes of scratch memory that make_examples() needs; 0 without examples.
std::size_t example_scratch_bytes(const Geometry& geometry);

// Fills in the pose-space members of `out`, whose layout must be filled in already. vertices: SSD's stream, to which
// each slot's row is written. Errors: unsupported (more than the smallest texture that GLES 3.0 allows can hold).
// Leaves the texture of the active unit at 0.
Status make_examples(const Api& api, const Geometry& geometry, float half_extent, std::byte* vertices,
                     Span<std::byte> scratch, GpuMesh& out);

}  // namespace marrow::gles3
