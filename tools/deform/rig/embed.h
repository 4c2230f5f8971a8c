// Which sphere of a mesh's room each knot of a template goes to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "deform/rig/room.h"
#include "deform/rig/skeleton_template.h"

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

}  // namespace marrow::deform
