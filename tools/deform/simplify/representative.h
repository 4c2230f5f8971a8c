// A few poses that stand for many.
#pragma once

#include <cstddef>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Representative {
  std::size_t pose;  // which of those given
  double weight;     // the share of poses that are most like it
};

// Up to `most` poses, `first` among them, each the least like those before it, by distances between a few hundred pairs
// of vertices: so it does not matter where a character stands and which way it looks. Weights sum to 1. The same on
// every run. Fewer where poses do not differ.
std::vector<Representative> representative_poses(const Deformer& deformer, const std::vector<Pose>& poses,
                                                 std::size_t first, std::size_t most);

}  // namespace marrow::deform
