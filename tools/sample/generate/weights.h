// Decides which joints move each vertex, and by how much.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "isosurface.h"
#include "shape.h"

namespace marrow::sample {

struct VertexWeights {
  std::array<std::uint8_t, 4> joints{};
  std::array<std::uint16_t, 4> weights{};  // of 65535; they sum to exactly that
};

std::vector<VertexWeights> make_weights(const Shape& shape, const Surface& surface);

}  // namespace marrow::sample
