// Weights of spherical linear interpolation.
#pragma once

#include "math/elementary.h"

namespace marrow {

template <class F>
struct SlerpWeights {
  F a, b;
};

// The weights of unit quaternions a and b at u in [0, 1], from the squared length of b - a (at most 2: the shorter
// arc): sin((1-u) θ) / sin θ and sin(u θ) / sin θ with sin(θ/2) = |b - a| / 2, all as even functions of θ, which leaves
// nothing to divide by zero at θ = 0. The angle is off by at most 4e-7 of itself.
template <class F>
inline SlerpWeights<F> slerp_weights(F chord_squared, F u) {
  const F half = asinc_for_slerp(all_lanes<F>(0.25f) * chord_squared);
  const F angle_squared = chord_squared * half * half;
  const F v = all_lanes<F>(1.0f) - u;
  const F whole = sinc_to_quarter_turn(angle_squared);
  return {v * sinc_to_quarter_turn(v * v * angle_squared) / whole,
          u * sinc_to_quarter_turn(u * u * angle_squared) / whole};
}

// sin(u θ) / sin θ as a polynomial in the squared chord, 2 (1 - cos θ), whose coefficients depend on u alone, so that
// many pairs of quaternions can share them (Eberly, "A fast and accurate algorithm for computing slerp", 2011). Cut
// after three terms: within 4e-7 up to a squared chord of kSlerpSeriesLimit, a turn by 26 degrees. At a chord of 0 the
// two weights' sum is exactly 1.
struct SlerpSeries {
  f32x4 c[3];
};
inline constexpr float kSlerpSeriesLimit = 0.054f;

inline SlerpSeries slerp_series(float u) {
  const float u2 = u * u;
  const float c1 = u * ((1.0f - u2) / 6.0f);  // (k² - u²) / (2k (2k + 1)) for k = 1, 2
  const float c2 = c1 * ((4.0f - u2) / 20.0f);
  return {{splat(u), splat(c1), splat(c2)}};
}
inline f32x4 slerp_weight(const SlerpSeries& series, f32x4 chord_squared) {
  return series.c[0] + chord_squared * (series.c[1] + chord_squared * series.c[2]);
}

}  // namespace marrow
