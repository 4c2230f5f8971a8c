// Sine and powers of two without libm, so that every processor gets the same; for easings.
#pragma once

#include "math/slerp.h"

namespace marrow {

// sin(2π turns) for |turns| < 2³⁰, within 2e-7. The reduction to a quarter of a turn is exact.
inline float sine_of_turns(float turns) {
  constexpr float kTwoPi = 6.28318531f;
  const int whole = static_cast<int>(turns < 0.0f ? turns - 0.5f : turns + 0.5f);
  float rest = turns - static_cast<float>(whole);  // -½ … ½
  if (rest > 0.25f) {
    rest = 0.5f - rest;
  } else if (rest < -0.25f) {
    rest = -0.5f - rest;
  }
  const float angle_rad = rest * kTwoPi;
  return angle_rad * sinc_of_square(angle_rad * angle_rad);
}

// 2^x for x in [-126, 0], within 2e-7 of itself; 1 at 0. 2^(x - round(x)) is a minimax fit of degree 6 over [-½, ½],
// within 2.7e-9; the rest is rounding.
inline float power_of_two(float x) {
  const int whole = static_cast<int>(x - 0.5f);  // towards zero
  const float f = x - static_cast<float>(whole);
  const float fraction =
      1.0f +
      f * (0.693147215f + f * (0.240226528f + f * (0.0555031055f +
                                                   f * (0.00961769297f + f * (0.00134066439f + f * 0.000155946775f)))));
  return fraction * __builtin_bit_cast(float, (whole + 127) << 23);
}

}  // namespace marrow
