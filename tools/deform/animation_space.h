// Animation space: Merry, Marais, Gain, "Animation space: a truly linear framework for character animation", ACM TOG
// 25(4), 2006; in the bind frame, see runtime/include/marrow/skin.h.
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "deform/skinned_mesh.h"
#include "deform/surface.h"

namespace marrow::deform {

// v' = Σ_j M_j q_j, with Σ_j (q_j)_w = 1.
struct Coordinate {
  std::uint32_t joint;
  glm::dvec4 q;
};
using Coordinates = std::vector<std::vector<Coordinate>>;  // a vertex: by ascending joint

std::vector<std::uint32_t> joints_of(const std::vector<Coordinate>& vertex);

Deformer animation_space(const Coordinates& coordinates);

// SSD exactly: q_j = w_j (v, 1).
Coordinates lift(const SkinnedMesh& mesh);

// SSD smoothed, which is linear, with the detail that smoothing takes from the bind pose put back by the smoothed
// weights: the third variant of Le and Lewis, "Direct delta mush skinning and variants", ACM TOG 38(4), 2019, in closed
// form. most: influences that a vertex keeps, the largest, and its own beyond that; what the others carried goes to
// those, and the bind pose stays.
Coordinates smoothed_ssd(const SkinnedMesh& mesh, const Surface& surface, int iterations, double step,
                         std::size_t most);

}  // namespace marrow::deform
