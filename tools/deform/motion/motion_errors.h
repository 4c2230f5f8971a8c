// How deformers fare over a range of motion: against the truth, and against linear blend skinning.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deform/motion/range_of_motion.h"

namespace marrow::deform {

// Of one deformer in one pose. What follows is about the surface where a joint's part goes over into the rest.
struct MotionFigures {
  double rms = 0;         // distance from the truth, over all vertices; lengths in the bind frame's unit
  bool is_worse = false;  // farther than SSD, by more than rounding; or not finite
  // Cut the surface where the joint's part is 1/8, 2/8 … 7/8: rings about the joint. A ring's radius is the mean
  // distance of its points from the line that the joint turns about. The narrowest, over what it is in the bind pose,
  // and the one that is narrowest beside the truth's. None: no ring has three points.
  std::optional<double> ring_over_bind, ring_over_truth;
  // What the surface there encloses with the joint's place, over the truth's. None: the truth's is about 0.
  std::optional<double> volume_over_truth;
  // Triangles that face against where they would, had each turned as its vertices' weights have it: by the blend of
  // quaternions. None do in the bind pose.
  std::size_t flipped = 0;
};

struct MotionErrors {
  bool is_usable = false;         // the truth is finite; else nothing here counts
  double ssd_rms = 0;             // linear blend skinning's distance from the truth
  std::size_t truth_flipped = 0;  // triangles of the truth; above 0 it folds, and nobody can say what is right
  std::optional<double> truth_ring_over_bind;
  std::vector<MotionFigures> of;  // each deformer
};

// Of each pose. Deformers, the truth too, take poses of the mesh's joints alone.
// On all cores; the same bits on every run and everywhere. Cost: for each pose all deformers, the truth and SSD.
std::vector<MotionErrors> motion_errors(const SkinnedMesh& mesh, const std::vector<MotionPose>& poses,
                                        const Deformer& truth, std::span<const Deformer> deformers);

// The poses, ascending, in which the truth does not fold and a deformer is worse than SSD: what a fit must not do.
std::vector<std::size_t> worse_than_ssd(const SkinnedMesh& mesh, const std::vector<MotionPose>& poses,
                                        const Deformer& truth, const Deformer& deformer);

}  // namespace marrow::deform
