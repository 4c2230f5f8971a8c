// Helpers must not make a character worse than linear blend skinning where nobody has looked.
#pragma once

#include <functional>
#include <vector>

#include "deform/helpers/helpers.h"

namespace marrow::deform {

// The sets of joints that linear blend skinning serves better: until no pose is farther from the truth than with it, by
// root mean square over all vertices, the set that adds most to the pose that is farthest beyond goes back to it.
//
// coordinates: over the mesh's joints and, behind them, `helpers`. pose: gives each of `poses`, of the joints alone,
// from any thread; those in which the truth is not finite do not count. Returns for each vertex whether it goes back.
// On all cores; the same result on every run. Cost: for each pose truth, SSD and coordinates; memory: 8 bytes · poses ·
// sets of joints.
std::vector<char> better_by_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                const std::vector<Helper>& helpers, std::size_t poses,
                                const std::function<Pose(std::size_t)>& pose, const Deformer& truth);

}  // namespace marrow::deform
