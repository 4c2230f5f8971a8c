// Skin weights evened out over a mesh's surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

inline constexpr int kMostSmoothSteps = 1000;

// Laplacian steps: each takes a vertex's weights half of the way to the mean of its neighbours', on borders too.
// Vertices at one place are one, so that seams in normals and UVs stay closed, and leave with the same weights; those
// without neighbours keep theirs. influences: by ascending joint, weights ≥ 0, none for a vertex that has no say. The
// result sums to 1 or is empty.
void smooth_weights(const Positions& positions, std::span<const std::uint32_t> indices, int steps,
                    std::vector<std::vector<Influence>>& influences);

}  // namespace marrow::deform
