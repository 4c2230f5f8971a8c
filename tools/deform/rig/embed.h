// Where a skeleton template goes in a mesh: its knots, then its joints between them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/rig/auto_skeleton.h"
#include "deform/rig/room.h"

namespace marrow::deform {

// What the search is about; lengths of the template times `scale` are voxels.
struct Embedding {
  const SkeletonTemplate& skeleton;
  const std::vector<Knot>& knots;
  const Room& room;
  MirrorPlane plane;
  double scale = 1;
};

// The sphere of each knot with the least sum of penalties, found by branch and bound: the bound is that of penalties
// between a knot and the one above it, least by dynamic programming over the tree. None where a knot has no sphere to
// go to.
std::optional<std::vector<std::size_t>> embed(const Embedding& embedding);

// spheres: of the knots. A joint of a chain stands as far along the way through the room as in the template. In grid
// coordinates.
std::vector<glm::dvec3> place_joints(const Embedding& embedding, const std::vector<std::size_t>& spheres);

// Moves joints, each a little after the other, as long as it lowers the sum of how far bones are off the middle of
// the mesh, how far their lengths are from the template's proportions, how far sides are from one another's mirror
// images, and how far joints are from where they were.
void refine_joints(const Embedding& embedding, std::vector<glm::dvec3>& places);

}  // namespace marrow::deform
