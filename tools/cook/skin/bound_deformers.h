// What multi-weights and pose space ask of palettes, and how they look from one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "cook/skin/skin_binding.h"

namespace marrow::cook {

// Joints that a palette must have for a vertex beside those that it follows.
std::vector<std::uint32_t> joints_of_deformers(const BoundDeformers& deformers, const BoundVertex& vertex);

// What build_geometry() takes of a primitive; joint j, if the palette has it, is entry entry_of[j] of palette_size.
DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size);

}  // namespace marrow::cook
