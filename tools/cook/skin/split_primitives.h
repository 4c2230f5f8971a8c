// Meshes with more joints than one palette may have, in parts that have fewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cook/scene/raw.h"
#include "cook/skin/skin_binding.h"

namespace marrow::cook {

// For each triangle which part it goes to, so that what the vertices of a part need is at most `most`. needs: of each
// vertex, ascending. Greedy: a part takes the triangles that add least to what it needs until they do not fit, one that
// has nothing in common with it only if no other is left; the next part begins there. Precondition: each triangle fits
// by itself.
std::vector<std::uint32_t> split_triangles(const std::vector<std::uint32_t>& indices,
                                           const std::vector<std::vector<std::uint32_t>>& needs, std::size_t most);

// As SkinBinding::part_of: parts of the primitives that need more than `most` palette entries. source: of failures.
// Throws tools::Failure (unsupported) if a triangle alone does, or if there would be more than kMostParts of one
// primitive.
inline constexpr std::size_t kMostParts = 4096;
std::vector<std::vector<std::uint32_t>> split_primitives(const std::string& source, const RawMesh& mesh,
                                                         std::size_t joint_count, std::size_t most,
                                                         const SkinBinding& binding);

// The vertices of a part, ascending, and its triangles, three vertices of the primitive each.
struct PrimitivePart {
  std::vector<std::uint32_t> vertices, indices;
};
// part_of: of each triangle; empty: one part that has all vertices, those that no triangle uses too.
std::vector<PrimitivePart> parts_of(const RawPrimitive& primitive, const std::vector<std::uint32_t>& part_of);

}  // namespace marrow::cook
