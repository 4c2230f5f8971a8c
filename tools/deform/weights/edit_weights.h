// Skin weights edited: those of some joints set and the others' made to fit, or all evened out over the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The given joints get the given weights (finite, ≥ 0; no joint twice), all scaled down where they sum to more than 1.
// The others share what is left as they did before; where there are none, the given ones keep it all. The `most`
// largest are kept. The result sums to 1, by ascending joint. False, and nothing is changed, where no joint would have
// weight.
bool set_weights(std::span<const Influence> given, std::size_t most, std::vector<Influence>& influences);

inline constexpr int kMostSmoothSteps = 1000;

// Laplacian steps: each takes a vertex's weights half of the way to the mean of its neighbours', on borders too.
// Vertices at one place are one, so that seams in normals and UVs stay closed, and leave with the same weights; those
// without neighbours keep theirs. influences: by ascending joint, weights ≥ 0, none for a vertex that has no say. The
// result sums to 1 or is empty.
void smooth_weights(const Positions& positions, std::span<const std::uint32_t> indices, int steps,
                    std::vector<std::vector<Influence>>& influences);

}  // namespace marrow::deform
