// A skeleton for a mesh that has none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/rig/skeleton_template.h"
#include "deform/skinned_mesh.h"

namespace marrow::deform {

enum class RigFailure {
  none,
  no_room,        // flat, empty, or so open that no inside is found
  several_parts,  // far from one another
  no_fit,         // no place for some part of the template
};

struct AutoSkeleton {
  RigFailure failure = RigFailure::none;
  std::vector<glm::dvec3> places;  // a joint of the template, ends too; in the mesh's units
  glm::ivec3 voxels{0};
  std::size_t spheres = 0;
};

// The mesh stands upright, +Y up, and faces +Z. Coordinates are finite and within ±1e30. The same bits everywhere.
AutoSkeleton auto_skeleton(const Positions& positions, std::span<const std::uint32_t> indices,
                           const SkeletonTemplate& skeleton);

}  // namespace marrow::deform
