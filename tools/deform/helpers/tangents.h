// Tangents of a surface as animation-space vectors: the runtime's as_tangents() (marrow/skin.h) in double precision,
// for vertices that are one where they coincide.
#pragma once

#include <array>
#include <vector>

#include "deform/animation_space.h"
#include "deform/helpers/helpers.h"

namespace marrow::deform {

// Of each vertex two tangents t = Σ_j M_j τ_j, over the joints and helpers of its coordinates; Σ_j (τ_j)_w = 0.
using TangentCoordinates = std::vector<std::array<std::vector<Coordinate>, 2>>;

// mesh: the bind pose. normals: of it, unit. helpers: numbered from mesh.joint_count on.
TangentCoordinates tangent_coordinates(const Coordinates& coordinates, const SkinnedMesh& mesh,
                                       const std::vector<glm::dvec3>& normals, const std::vector<Helper>& helpers);

// t₀ × t₁ in a pose, unit; 0 where that has no direction.
std::vector<glm::dvec3> surface_normals(const TangentCoordinates& tangents, const Pose& pose);

}  // namespace marrow::deform
