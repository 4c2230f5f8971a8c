// Cosine and sine of one angle, the same bits on every processor.
#pragma once

#include "math/quaternion.h"

namespace marrow {

struct CosSin {
  float cos, sin;
};

// Within 1e-6 for up to a whole turn either way; what is not finite gives NaN.
[[gnu::noinline]] inline CosSin cos_sin(float angle_rad) {
  constexpr float kRounds = 12582912.0f;  // 3 · 2²²: what is added to it loses its fraction
  const float turns = (angle_rad * 0.159154943f + kRounds) - kRounds;
  const float rest = (angle_rad - turns * 6.28125f) - turns * 1.93530718e-3f;
  float c[4], s[4];
  store(c, cos_of_root(splat(rest * rest)));
  store(s, sinc_of_root(splat(rest * rest)));
  return {c[0], s[0] * rest};
}

}  // namespace marrow
