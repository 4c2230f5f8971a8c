// What is learnt must not make a character worse than linear blend skinning, nor look worse, where nobody has looked.
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

struct Ugliness {
  double total = 0;  // triangles that turn over and edges that bend, by the coordinates, over all poses and vertices
  // Of each vertex how much of what it has learnt it must do without, 0 … 1: where that looks worse than both linear
  // blend skinning and what it would go back to. Smooth over the surface, so that what goes back shows no seam.
  std::vector<double> goes_back;
};

// Whether it looks worse is a matter of FoldMeter's sums at vertices: by a quarter, and by more than nobody sees.
// simple: what coordinates go back to. coordinates and helpers as of better_by_ssd(); poses: of joints alone. On all
// cores; the same result on every run.
Ugliness uglier_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates, const Coordinates& simple,
                         const std::vector<Helper>& helpers, const std::vector<Pose>& poses);

// Of each vertex how much of what it has learnt it must do without, since it jumps from frame to frame, |a - 2 b + c|,
// by a quarter more than with linear blend skinning and with `simple`, and by more than a thousandth of the diagonal:
// 0 … 1, smooth over the surface. On all cores; the same result on every run.
std::vector<double> jumps_more_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                        const Coordinates& simple, const std::vector<Helper>& helpers,
                                        const std::vector<FramesInARow>& frames);

}  // namespace marrow::deform
