// What is learnt must not look worse than linear blend skinning where nobody has looked.
#pragma once

#include <vector>

#include "deform/helpers/helpers.h"

namespace marrow::deform {

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
