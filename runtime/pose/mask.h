// Per-joint factors of weights.
#pragma once

#include <cstddef>

#include "marrow/span.h"
#include "math/finite.h"

namespace marrow {

// The mask's factors of one group, whatever the caller wrote there: 0 … 1.
inline f32x4 factors(Span<const float> mask, std::size_t group) {
  return mask.empty() ? splat(1.0f) : clamp_to_unit(load(mask.data + 4 * group));
}

}  // namespace marrow
