// The weights of a lattice's corners.
#pragma once

#include <vector>

#include "deform/elastic/lattice.h"

namespace marrow::deform {

// As smooth as they can be while between corners they are what vertices have: of each joint the least of
// 4 Σ (interpolated - vertex's)² + Σ |gradient|². Of each corner the six largest, none below 0.01; they sum to 1.
// On all cores, the same on every run.
std::vector<std::vector<Influence>> node_weights(const Lattice& lattice, const SkinnedMesh& mesh);

}  // namespace marrow::deform
