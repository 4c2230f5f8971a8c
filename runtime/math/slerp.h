// Weights of spherical linear interpolation without trigonometry from a library, so that every processor gets the same.
#pragma once

#include <cstddef>

#include "math/f32x4.h"

namespace marrow {

// c[0] + y (c[1] + y (…)); F is float or f32x4.
template <std::size_t N>
inline float horner(const float (&c)[N], float y) {
  float sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = c[i] + y * sum;
  return sum;
}
template <std::size_t N>
inline f32x4 horner(const float (&c)[N], f32x4 y) {
  f32x4 sum = splat(c[N - 1]);
  for (std::size_t i = N - 1; i-- > 0;) sum = splat(c[i]) + y * sum;
  return sum;
}

// sin(√y) / √y for y in [0, (π/2)²], within 5e-9. Minimax fit of degree 4.
template <class F>
inline F sinc_of_square(F y) {
  constexpr float kFit[] = {0.999999996f, -0.166666580f, 8.33305098e-3f, -1.98090690e-4f, 2.60521026e-6f};
  return horner(kFit, y);
}

// asin(√z) / √z for z in [0, ½], within 1.1e-7. Minimax fit of degree 6.
template <class F>
inline F asinc_of_square(F z) {
  constexpr float kFit[] = {1.00000011f, 0.16664676f, 0.07559077f, 0.03815005f, 0.06348833f, -0.05957173f, 0.10395446f};
  return horner(kFit, z);
}

inline float constant(float, float value) {
  return value;
}
inline f32x4 constant(f32x4, float value) {
  return splat(value);
}

template <class F>
struct SlerpWeights {
  F a, b;
};

// The weights of unit quaternions a and b at u in [0, 1], from the squared length of b - a (at most 2: the shorter
// arc): sin((1-u) θ) / sin θ and sin(u θ) / sin θ with sin(θ/2) = |b - a| / 2, all as even functions of θ, which leaves
// nothing to divide by zero at θ = 0. The angle is off by at most 4e-7 of itself.
template <class F>
inline SlerpWeights<F> slerp_weights(F chord_squared, F u) {
  const F half = asinc_of_square(constant(u, 0.25f) * chord_squared);
  const F angle_squared = chord_squared * half * half;
  const F v = constant(u, 1.0f) - u;
  const F whole = sinc_of_square(angle_squared);
  return {v * sinc_of_square(v * v * angle_squared) / whole, u * sinc_of_square(u * u * angle_squared) / whole};
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
