// Where the blocks of a SkinnedMesh's buffer are.
#pragma once

#include "gles3/gl_constants.h"
#include "marrow/gles3_skinned.h"

namespace marrow::gles3 {

// Bytes; what the mesh lacks has none.
struct SkinnedBlocks {
  std::uint32_t position_bytes = 0, normal_bytes = 0, tangent_bytes = 0;
  std::uint32_t normals = 0, tangents = 0;  // where they begin
  std::uint32_t bytes = 0;
};
SkinnedBlocks blocks_of(const SkinnedMesh& mesh);

// create_skinned(), with a name for labels.
Status make_skinned(const Api& api, const GpuMesh& mesh, const char* name, SkinnedMesh& out);

}  // namespace marrow::gles3
