// A number of each of the problems that go at once: four, a lane each, or one where code is to be small. The bits are
// the same.
#pragma once

#include <type_traits>

#include "core/fixed.h"
#include "math/lane.h"

namespace marrow {

using Number = std::conditional_t<kSmall, One, f32x4>;
inline Number number(float x) {
  return all_lanes<Number>(x);
}

}  // namespace marrow
