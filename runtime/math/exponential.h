// The exponential of four numbers at once, without a library: the same bits everywhere.
#pragma once

#include "math/f32x4.h"

namespace marrow {

// e^x for x ≤ 0, within 2e-7 of itself: exactly 1 at 0, and 1.6e-38 for all below -87. Above 0 it soon gives anything;
// NaN gives NaN.
//
// e^x = 2^n e^f with n the whole number next to x log₂ e, f at most half of ln 2 either way; a minimax fit of degree 6
// there, within 4.4e-9.
inline f32x4 exp_negative(f32x4 x) {
  const f32x4 least = splat(-87.0f);
  x = select(x < least, least, x);
  constexpr float kLog2e = 1.44269504f, kLn2High = 0.693359375f, kLn2Low = -2.12194440e-4f;
  // Has n in its lowest bits and nothing that 23 places to the left would leave in.
  const f32x4 magic = splat(12582912.0f), shifted = x * splat(kLog2e) + magic;
  const f32x4 n = shifted - magic;
  const f32x4 f = (x - n * splat(kLn2High)) - n * splat(kLn2Low);
  constexpr float c[] = {0.49999994f, 0.166665196f, 0.0416683927f, 0.00836878177f, 0.00138144684f};
  f32x4 sum = splat(c[4]);
  for (int i = 3; i >= 0; --i) sum = splat(c[i]) + f * sum;
  const f32x4 power = bits_as_float(shift_left<23>(float_as_bits(shifted) + splat_int(127)));
  return power * (splat(1.0f) + f * (splat(1.0f) + f * sum));
}

}  // namespace marrow
