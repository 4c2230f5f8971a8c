// Turns the implicit surface into a watertight triangle mesh that is the same on both sides of x = 0.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "shape.h"

namespace marrow::sample {

using Triangle = std::array<std::uint32_t, 3>;

struct Surface {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;  // counter-clockwise from outside
};

// The left half (x >= 0), open along the plane x = 0, raw: fine grid, uneven triangles.
Surface polygonise_left_half(const Shape& shape, glm::vec3 low, glm::vec3 high, float cell);

// Evens out the triangles of the left half to the lengths that `shape` asks for.
void remesh_half(const Shape& shape, Surface& half, int rounds);

// Adds the right half and welds the two along x = 0.
Surface mirror_half(const Surface& half);

// Every edge has exactly two triangles that run along it in opposite directions.
bool is_watertight(const Surface& surface);

// For each vertex, its neighbours along edges, ascending.
std::vector<std::vector<std::uint32_t>> vertex_neighbours(const Surface& surface);

}  // namespace marrow::sample
