// What is learnt must not look worse than linear blend skinning where nobody has looked.
#pragma once

#include <functional>
#include <vector>

#include "deform/helpers/helpers.h"

namespace marrow::deform {

// Of each vertex how much of what it has learnt it must do without, 0 … 1: where by the coordinates, over all poses,
// triangles turn over and edges bend by more than a tenth more than by linear blend skinning. Smooth over the surface,
// so that what goes back shows no seam.
// coordinates, helpers and pose as of better_by_ssd(). On all cores; the same result on every run.
std::vector<double> uglier_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                    const std::vector<Helper>& helpers, std::size_t poses,
                                    const std::function<Pose(std::size_t)>& pose);

}  // namespace marrow::deform
