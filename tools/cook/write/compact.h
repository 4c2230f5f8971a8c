// Skeletons, meshes and names as packed files hold them; runtime/unpack/structure.h reads them.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/scene/built.h"

namespace marrow::cook {

// `name`: of the skeleton, an offset plus one, or 0 if it is the next new one; of joints likewise.
std::vector<std::byte> compact_skeleton(const BuiltSkeleton& skeleton, std::uint32_t name,
                                        const std::vector<std::uint32_t>& joint_names);
// `header` is the section's; the names are targets'.
std::vector<std::byte> compact_mesh(const BuiltMesh& mesh, const format::MeshHeader& header,
                                    const std::vector<MeshTarget>& targets);
std::vector<std::byte> compact_names(const std::vector<char>& pool);

// Of memory, to unpack meshes of this skeleton.
std::uint64_t compact_scratch_bytes(const BuiltSkeleton& skeleton);

}  // namespace marrow::cook
