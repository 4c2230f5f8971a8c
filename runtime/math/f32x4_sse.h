// f32x4 with SSE2.
#pragma once

#include <emmintrin.h>

#include <cstdint>

namespace marrow {

struct f32x4 {
  __m128 v;
};
struct mask4 {
  __m128 v;
};

inline f32x4 load(const float* p) {
  return {_mm_loadu_ps(p)};
}
// From a multiple of 16 bytes: may be folded into what uses it.
inline f32x4 load_aligned(const float* p) {
  return {_mm_load_ps(p)};
}
inline f32x4 from_ints(const std::int32_t* p) {
  return {_mm_cvtepi32_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)))};
}
inline void store(float* p, f32x4 a) {
  _mm_storeu_ps(p, a.v);
}
inline f32x4 splat(float s) {
  return {_mm_set1_ps(s)};
}
inline f32x4 operator+(f32x4 a, f32x4 b) {
  return {_mm_add_ps(a.v, b.v)};
}
inline f32x4 operator-(f32x4 a, f32x4 b) {
  return {_mm_sub_ps(a.v, b.v)};
}
inline f32x4 operator*(f32x4 a, f32x4 b) {
  return {_mm_mul_ps(a.v, b.v)};
}
inline f32x4 operator/(f32x4 a, f32x4 b) {
  return {_mm_div_ps(a.v, b.v)};
}
inline f32x4 sqrt(f32x4 a) {
  return {_mm_sqrt_ps(a.v)};
}
inline mask4 operator<(f32x4 a, f32x4 b) {
  return {_mm_cmplt_ps(a.v, b.v)};
}
inline f32x4 select(mask4 m, f32x4 yes, f32x4 no) {
  return {_mm_or_ps(_mm_and_ps(m.v, yes.v), _mm_andnot_ps(m.v, no.v))};
}
inline bool any(mask4 m) {
  return _mm_movemask_ps(m.v) != 0;
}
// a between 0 and 1; NaN gives 0.
inline f32x4 clamp_to_unit(f32x4 a) {
  return {_mm_min_ps(_mm_max_ps(a.v, _mm_setzero_ps()), _mm_set1_ps(1.0f))};
}
// a, negated where the sign bit of `by` is set.
inline f32x4 flip(f32x4 a, f32x4 by) {
  return {_mm_xor_ps(a.v, _mm_and_ps(by.v, _mm_set1_ps(-0.0f)))};
}

template <int Lane>
inline f32x4 splat_lane(f32x4 a) {
  return {_mm_castsi128_ps(_mm_shuffle_epi32(_mm_castps_si128(a.v), Lane * 0x55))};
}
// 0, 0, 0, a.w
inline f32x4 only_w(f32x4 a) {
  return {_mm_and_ps(a.v, _mm_castsi128_ps(_mm_setr_epi32(0, 0, 0, -1)))};
}
inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  _MM_TRANSPOSE4_PS(a.v, b.v, c.v, d.v);
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  const __m128 x0y0x1y1 = _mm_unpacklo_ps(x.v, y.v);
  const __m128 x2y2x3y3 = _mm_unpackhi_ps(x.v, y.v);
  const __m128 z0__x1_ = _mm_shuffle_ps(z.v, x.v, _MM_SHUFFLE(1, 1, 0, 0));
  const __m128 y1__z1_ = _mm_shuffle_ps(y.v, z.v, _MM_SHUFFLE(1, 1, 1, 1));
  const __m128 z2__x3_ = _mm_shuffle_ps(z.v, x.v, _MM_SHUFFLE(3, 3, 2, 2));
  const __m128 y3__z3_ = _mm_shuffle_ps(y.v, z.v, _MM_SHUFFLE(3, 3, 3, 3));
  _mm_storeu_ps(p, _mm_shuffle_ps(x0y0x1y1, z0__x1_, _MM_SHUFFLE(2, 0, 1, 0)));
  _mm_storeu_ps(p + 4, _mm_shuffle_ps(y1__z1_, x2y2x3y3, _MM_SHUFFLE(1, 0, 2, 0)));
  _mm_storeu_ps(p + 8, _mm_shuffle_ps(z2__x3_, y3__z3_, _MM_SHUFFLE(2, 0, 2, 0)));
}

}  // namespace marrow
