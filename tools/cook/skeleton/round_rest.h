// Rest poses as packed files hold them (runtime/unpack/rest.h), rounded before anything is built on them.
#pragma once

#include "cook/scene/built.h"

namespace marrow::cook {

// Rotations to 2e-6 rad, translations to 2^-23 of the longest one, scales within 1e-6 of one to one. Fills in
// rotation_codes and translation_exponent.
void round_rest(BuiltSkeleton& skeleton);

}  // namespace marrow::cook
