// Which joints a primitive's vertices are bound to.
#pragma once

#include <cstdint>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "cook/scene/built.h"
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

}  // namespace marrow::cook
