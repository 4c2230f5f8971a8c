// Which helpers are worth their bytes.
#pragma once

#include <cstddef>

#include "deform/helpers/closed_form.h"

namespace marrow::deform {

// Helpers between the pairs of joints that vertices share: at a half for a pair at first, then at quarters, then at
// eighths, whichever misses least by the closed form, up to `most`.
//
// What a vertex of weights a and b misses of its pair is 2 a b (1 - G_ij) without a helper, and of the part between two
// helpers the same of that part; squared, summed over vertices. Without poses pairs so come in the order of Σ (a b)².
// Steps that gain less than a hundred-thousandth of the first are left out.
// places: of joints in the bind pose. about_centres: each helper turns about the mean of its vertices' centres of
// rotation, weighed by (a b)², instead of blending dual quaternions. parts: what helpers may divide a pair into, 2, 4
// or 8.
std::vector<Helper> choose_helpers(const SkinnedMesh& mesh, const Likeness& likeness,
                                   const std::vector<glm::dvec3>& places, std::size_t most, bool about_centres,
                                   int parts);

}  // namespace marrow::deform
