// Weights of some joints of a vertex set, and the others' made to fit.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The given joints get the given weights (finite, ≥ 0; no joint twice), all scaled down where they sum to more than 1.
// The others share what is left as they did before; where there are none, the given ones keep it all. The `most`
// largest are kept. The result sums to 1, by ascending joint. False, and nothing is changed, where no joint would have
// weight.
bool set_weights(std::span<const Influence> given, std::size_t most, std::vector<Influence>& influences);

}  // namespace marrow::deform
