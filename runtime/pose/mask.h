// Per-joint factors of weights.
#pragma once

#include <cstddef>

#include "marrow/span.h"
#include "math/finite.h"

namespace marrow {

// A group's factors from the mask, clamped to 0 … 1; 1 without a mask.
inline f32x4 factors(Span<const float> mask, std::size_t group) {
  return mask.empty() ? splat(1.0f) : clamp_to_unit(load(mask.data + 4 * group));
}

}  // namespace marrow
