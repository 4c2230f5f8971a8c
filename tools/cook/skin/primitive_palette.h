// Which joints a primitive's vertices are bound to, and its parts where those are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "cook/skin/skin_binding.h"

namespace marrow::cook {

struct Palette {
  std::vector<std::uint16_t> joints;  // of the skeleton
  std::vector<Affine> inverse_bind;
  std::vector<Helper> helpers;
  std::vector<float> helper_centres;  // as Mesh::helper_centres
  std::size_t size() const { return joints.size() + helpers.size(); }
};

// Joints and helpers that a palette must have for a vertex, ascending: those that it and its deformers follow, and
// those that helpers blend. joint_count: of the skin; helpers stand behind.
std::vector<std::uint32_t> palette_needs(const SkinBinding& binding, std::size_t joint_count,
                                         const BoundVertex& vertex);

// What all these vertices need; entries in the skin's order, entry_of the way there. Throws tools::Failure
// (unsupported), without a place, if the format has no room for them.
Palette make_palette(const RawSkin& skin, const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                     const std::vector<int>& joint_of_node, std::vector<std::uint16_t>& entry_of);

// Some entries of a palette, ascending; those that its helpers blend must be among them.
Palette some_of(const Palette& whole, const std::vector<std::uint16_t>& entries);

// With palette entries in place of joints.
std::vector<Binding> bind_vertices(const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                                   const std::vector<std::uint16_t>& entry_of);

// What build_geometry() takes of a primitive; joint j, if the palette has it, is entry entry_of[j] of palette_size.
DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size);

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
