// Vertices at one place as one: seams part a mesh's vertices, not its surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Places {
  std::vector<std::uint32_t> of_vertex;
  Positions positions;  // of places, ascending
};
Places places_of(const Positions& positions);

// Triangles of places.
std::vector<std::uint32_t> indices_of(const Places& places, std::span<const std::uint32_t> indices);

}  // namespace marrow::deform
