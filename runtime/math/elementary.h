// Sine, cosine, arc sine, exponential and powers of two without a library: the same bits on every processor, for a
// float as for four lanes. F: see math/lane.h. Functions that only one type needs are not templates.
//
// Sine, cosine and arc sine come as even functions, of the square of their argument: no root is needed, and nothing is
// divided by zero.
#pragma once

#include <cstddef>

#include "core/builtins.h"
#include "math/lane.h"

namespace marrow {

// c[0] + y (c[1] + y (…)).
template <class F>
inline F horner(const float* c, std::size_t count, F y) {
  F sum = all_lanes<F>(c[count - 1]);
  for (std::size_t i = count - 1; i-- > 0;) sum = all_lanes<F>(c[i]) + y * sum;
  return sum;
}
template <std::size_t N, class F>
inline F horner(const float (&c)[N], F y) {
  return horner(c, N, y);
}

// Each of the next three is exactly 1 at 0, so that the identity rotation stays exact.

// cos √y for y in [0, π²], within 1.2e-8 and rounding. Minimax fit of degree 6.
template <class F>
inline F cos_of_root(F y) {
  static constexpr float kFit[] = {1.0f,          -0.499999925f,   0.0416665179f, -1.3887906e-3f,
                                   2.4771644e-5f, -2.70934882e-7f, 1.72906225e-9f};
  return horner(kFit, y);
}

// sin √y / √y for y in [0, π²], within 8.1e-10 and rounding. Minimax fit of degree 6.
template <class F>
inline F sinc_of_root(F y) {
  static constexpr float kFit[] = {1.0f,           -0.166666662f,   8.33332324e-3f, -1.98406033e-4f,
                                   2.75370391e-6f, -2.47385713e-8f, 1.36438182e-10f};
  return horner(kFit, y);
}

// asin √z / √z for z in [0, ½], within 1.7e-8 and rounding. Minimax fit of degree 7.
template <class F>
inline F asinc_of_root(F z) {
  static constexpr float kFit[] = {1.0f,          0.16666916f, 0.0748808732f,  0.0465528862f,
                                   0.0160917654f, 0.07785701f, -0.0939145603f, 0.112058543f};
  return horner(kFit, z);
}

// The same with fewer terms, for the weights of slerp. The weights are quotients, so an error that all functions share
// cancels, and they need not be exactly 1 at 0. Poses depend on their bits.

// sin √y / √y for y in [0, (π/2)²], within 5e-9. Minimax fit of degree 4.
template <class F>
inline F sinc_to_quarter_turn(F y) {
  static constexpr float kFit[] = {0.999999996f, -0.166666580f, 8.33305098e-3f, -1.98090690e-4f, 2.60521026e-6f};
  return horner(kFit, y);
}

// asin √z / √z for z in [0, ½], within 1.1e-7. Minimax fit of degree 6.
template <class F>
inline F asinc_for_slerp(F z) {
  static constexpr float kFit[] = {1.00000011f, 0.16664676f,  0.07559077f, 0.03815005f,
                                   0.06348833f, -0.05957173f, 0.10395446f};
  return horner(kFit, z);
}

// The same for negative arguments too, where the cosine becomes cosh √-y and the sine sinh √-y: for overdamped
// oscillators. Taylor series; the error is within 3e-6 · cosh √8 for all arguments in [-8, 4.2].

// sin √q / √q.
template <class F>
inline F sinc_of_signed_root(F q) {
  static constexpr float kSeries[] = {1.0f,          -1.0f / 6,        1.0f / 120,          -1.0f / 5040,
                                      1.0f / 362880, -1.0f / 39916800, 1.0f / 6227020800.0f};
  return horner(kSeries, q);
}

// cos √p, and the divided difference (cos √p - cos √q) / (p - q), by Horner's scheme without cancellation.
template <class F>
inline F cos_of_signed_root(F p, F q, F& slope) {
  static constexpr float kSeries[] = {1.0f,         -1.0f / 2,       1.0f / 24,       -1.0f / 720,
                                      1.0f / 40320, -1.0f / 3628800, 1.0f / 479001600};
  F sum = all_lanes<F>(kSeries[6]);
  slope = all_lanes<F>(0.0f);
  for (int i = 5; i >= 0; --i) {
    slope = slope * q + sum;
    sum = sum * p + all_lanes<F>(kSeries[i]);
  }
  return sum;
}

struct CosSin {
  float cos, sin;
};

// Within 1e-6 for up to a whole turn either way; what is not finite gives NaN.
[[gnu::noinline]] inline CosSin cos_sin(float angle_rad) {
  constexpr float kRounds = 12582912.0f;  // 3 · 2²²: a number that is added to it loses its fraction
  const float turns = (angle_rad * 0.159154943f + kRounds) - kRounds;
  const float rest = (angle_rad - turns * 6.28125f) - turns * 1.93530718e-3f;
  return {cos_of_root(rest * rest), sinc_of_root(rest * rest) * rest};
}

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
  return angle_rad * sinc_to_quarter_turn(angle_rad * angle_rad);
}

// 2^x for x in [-126, 0], within 2e-7 of itself; 1 at 0. 2^(x - round(x)) is a minimax fit of degree 6 over [-½, ½],
// within 2.7e-9; the rest is rounding.
inline float power_of_two(float x) {
  const int whole = static_cast<int>(x - 0.5f);  // towards zero
  static constexpr float kFit[] = {1.0f,           0.693147215f,   0.240226528f,   0.0555031055f,
                                   0.00961769297f, 0.00134066439f, 0.000155946775f};
  const float fraction = horner(kFit, x - static_cast<float>(whole));
  return fraction * bit_cast<float>((whole + 127) << 23);
}

// e^x for x ≤ 0, within 2e-7 of itself: exactly 1 at 0, and 1.6e-38 for all below -87. Above 0 it soon gives anything;
// NaN gives NaN.
//
// e^x = 2^n e^f with n = round(x log₂ e) and |f| ≤ ½ ln 2. e^f is a minimax fit of degree 6, within 4.4e-9.
inline f32x4 exp_negative(f32x4 x) {
  const f32x4 least = splat(-87.0f);
  x = select(x < least, least, x);
  constexpr float kLog2e = 1.44269504f, kLn2High = 0.693359375f, kLn2Low = -2.12194440e-4f;
  // `shifted` has n in its lowest bits. Shifting it left by 23 pushes out all its other bits.
  const f32x4 magic = splat(12582912.0f), shifted = x * splat(kLog2e) + magic;
  const f32x4 n = shifted - magic;
  const f32x4 f = (x - n * splat(kLn2High)) - n * splat(kLn2Low);
  static constexpr float kFit[] = {1.0f,          1.0f,           0.49999994f,   0.166665196f,
                                   0.0416683927f, 0.00836878177f, 0.00138144684f};
  const f32x4 power = bits_as_float(shift_left<23>(float_as_bits(shifted) + splat_int(127)));
  return power * horner(kFit, f);
}
inline float exp_negative(float x) {
  return first_lane(exp_negative(splat(x)));
}

}  // namespace marrow
