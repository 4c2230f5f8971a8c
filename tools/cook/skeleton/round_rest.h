// Rest poses and helpers' centres as packed files hold them (runtime/unpack/rest.h), rounded before anything is built
// on them.
#pragma once

#include "cook/scene/built.h"

namespace marrow::cook {

// Rotations to 2e-6 rad, translations to 2^-23 of the longest one, scales within 1e-6 of one to one. Fills in
// rotation_codes and translation_exponent.
void round_rest(BuiltSkeleton& skeleton);

// Places to 2^-13 of the largest coordinate: whole numbers times 2 to the power that it gives.
std::int32_t round_centres(std::vector<float>& centres);

}  // namespace marrow::cook
