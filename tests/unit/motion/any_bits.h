// Floats of any bits, among good ones.
#pragma once

#include <cstring>

#include "support/rig.h"

namespace marrow::test {

// One in `one_in` is any bits; the others are in 0 … most.
inline float any_float(Random& random, std::uint32_t one_in, double most) {
  const std::uint32_t bits = random.bits() << 1 ^ random.bits();
  float out;
  std::memcpy(&out, &bits, sizeof out);
  return random.below(one_in) == 0 ? out : static_cast<float>(random.between(0, most));
}

}  // namespace marrow::test
