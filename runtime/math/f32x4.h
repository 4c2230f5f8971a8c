// Four floats at once: the only place that speaks an instruction set. Every backend gives the same bits, operation by
// operation: no fused multiply-add, no estimates, comparisons false on NaN.
#pragma once

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ > 0
#error "floats are computed with more bits than they have (the x87 of i386): compile with -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__)
#error "-ffast-math changes the bits of poses and takes NaN for a number: compile Marrow without it"
#endif

#if !defined(MARROW_SCALAR) && (defined(__SSE2__) || defined(_M_X64))
#include "math/f32x4_sse.h"
#elif !defined(MARROW_SCALAR) && defined(__aarch64__)
#include "math/f32x4_neon.h"
#elif !defined(MARROW_SCALAR) && defined(__wasm_simd128__)
#include "math/f32x4_wasm.h"
#else
// 32-bit ARM comes here too: its NEON flushes denormals and divides by estimates.
#include "math/f32x4_scalar.h"
#endif

namespace marrow {

// 1 / length from a squared length; 0 for 0, so that what has no direction stays zero.
[[gnu::always_inline]] inline f32x4 inverse_length(f32x4 squared) {
  const f32x4 zero = splat(0.0f);
  return select(zero < squared, splat(1.0f) / sqrt(squared), zero);
}

#if !defined(MARROW_F32X4_SUMS_THREE)
// {Σ a, Σ b, Σ c, Σ c}, each as sum_of_lanes(); w of a, b and c must be 0.
inline f32x4 three_sums(f32x4 a, f32x4 b, f32x4 c) {
  f32x4 again = c;
  transpose(a, b, c, again);
  return a + b + c;
}
#endif

#if !defined(MARROW_F32X4_SUMS)
// {x.x + x.y + x.z, the same of y, the same of z, 0}, each summed from left to right.
inline f32x4 sums(f32x4 x, f32x4 y, f32x4 z) {
  f32x4 none = splat(0.0f);
  transpose(x, y, z, none);
  return x + y + z;
}
#endif

#if !defined(MARROW_F32X4_LOADS_TRANSPOSED)
// Loads four vectors, each 16-byte aligned, and transposes them.
inline void load_transposed(const float* a, const float* b, const float* c, const float* d, f32x4& x, f32x4& y,
                            f32x4& z, f32x4& w) {
  x = load_aligned(a);
  y = load_aligned(b);
  z = load_aligned(c);
  w = load_aligned(d);
  transpose(x, y, z, w);
}
#endif

}  // namespace marrow
