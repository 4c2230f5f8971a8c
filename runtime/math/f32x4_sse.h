// f32x4 with SSE2.
#pragma once

#include <emmintrin.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace marrow {

// Instructions take an operand from memory: what is used once need not be loaded first.
inline constexpr bool kMemoryOperands = true;

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
// Four numbers that whole vectors are multiplied by, kept as this instruction set does that best: each in all lanes.
struct Factors {
  f32x4 lane[4];
};
inline Factors factors(f32x4 a) {
  return {{splat_lane<0>(a), splat_lane<1>(a), splat_lane<2>(a), splat_lane<3>(a)}};
}
template <int Lane>
inline f32x4 times(f32x4 v, const Factors& f) {
  return v * f.lane[Lane];
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
  const auto store_low = [](float* to, __m128 v) { _mm_storel_pi(reinterpret_cast<__m64*>(to), v); };
  const auto store_high = [](float* to, __m128 v) { _mm_storeh_pi(reinterpret_cast<__m64*>(to), v); };
  const __m128 z0z2x1x3 = _mm_shuffle_ps(z.v, x.v, _MM_SHUFFLE(3, 1, 2, 0));
  const __m128 z0x1z2x3 = _mm_shuffle_ps(z0z2x1x3, z0z2x1x3, _MM_SHUFFLE(3, 1, 2, 0));
  store_low(p, _mm_unpacklo_ps(x.v, y.v));
  store_low(p + 2, z0x1z2x3);
  store_high(p + 4, _mm_unpacklo_ps(y.v, z.v));
  store_low(p + 6, _mm_unpackhi_ps(x.v, y.v));
  store_high(p + 8, z0x1z2x3);
  store_high(p + 10, _mm_unpackhi_ps(y.v, z.v));
}

// Sixteen floats: x0 y0 z0 w0 x1 y1 z1 w1 …
inline void store_xyzw(float* p, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  transpose(x, y, z, w);
  store(p, x);
  store(p + 4, y);
  store(p + 8, z);
  store(p + 12, w);
}

// Four 32-bit and two 64-bit words, for unpacking.
struct i32x4 {
  __m128i v;
};
struct u64x2 {
  __m128i v;
};

inline i32x4 splat_int(std::int32_t s) {
  return {_mm_set1_epi32(s)};
}
inline i32x4 operator+(i32x4 a, i32x4 b) {
  return {_mm_add_epi32(a.v, b.v)};
}
inline i32x4 operator&(i32x4 a, i32x4 b) {
  return {_mm_and_si128(a.v, b.v)};
}
template <int Bits>
inline i32x4 shift_left(i32x4 a) {
  return {_mm_slli_epi32(a.v, Bits)};
}
inline f32x4 to_float(i32x4 a) {
  return {_mm_cvtepi32_ps(a.v)};
}
inline f32x4 bits_as_float(i32x4 a) {
  return {_mm_castsi128_ps(a.v)};
}
// One word from each place, whatever its alignment.
inline i32x4 gather_words(const std::byte* const (&p)[4]) {
  const auto word = [](const std::byte* at) {
    std::int32_t w;
    std::memcpy(&w, at, 4);
    return _mm_cvtsi32_si128(w);
  };
  return {_mm_unpacklo_epi64(_mm_unpacklo_epi32(word(p[0]), word(p[1])), _mm_unpacklo_epi32(word(p[2]), word(p[3])))};
}
// Four int16 from each place, times 65536; component by component, one lane a place.
inline void gather_int16(const std::byte* const (&p)[4], i32x4 (&out)[4]) {
  const auto half = [](const std::byte* at) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)); };
  const auto pair = [half](const std::byte* a, const std::byte* b) { return _mm_unpacklo_epi16(half(a), half(b)); };
  const __m128i ab = pair(p[0], p[1]), cd = pair(p[2], p[3]);  // x0 x1 y0 y1 …
  const __m128i xy = _mm_unpacklo_epi32(ab, cd), zw = _mm_unpackhi_epi32(ab, cd);
  const __m128i zero = _mm_setzero_si128();
  out[0] = {_mm_unpacklo_epi16(zero, xy)};
  out[1] = {_mm_unpackhi_epi16(zero, xy)};
  out[2] = {_mm_unpacklo_epi16(zero, zw)};
  out[3] = {_mm_unpackhi_epi16(zero, zw)};
}
// Four times four int16 one after the other, times 65536; component by component.
inline void load_int16(const std::byte* p, i32x4 (&out)[4]) {
  const __m128i ab = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
  const __m128i cd = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p) + 1);
  const __m128i ac = _mm_unpacklo_epi16(ab, cd), bd = _mm_unpackhi_epi16(ab, cd);
  const __m128i xy = _mm_unpacklo_epi16(ac, bd), zw = _mm_unpackhi_epi16(ac, bd), zero = _mm_setzero_si128();
  out[0] = {_mm_unpacklo_epi16(zero, xy)};
  out[1] = {_mm_unpackhi_epi16(zero, xy)};
  out[2] = {_mm_unpacklo_epi16(zero, zw)};
  out[3] = {_mm_unpackhi_epi16(zero, zw)};
}
// Sixty-four bits from each of two places, whatever their alignment.
inline u64x2 load_pair(const std::byte* a, const std::byte* b) {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(a));
  return {_mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(b)))};
}
inline u64x2 load_aligned(const std::uint64_t* p) {
  return {_mm_load_si128(reinterpret_cast<const __m128i*>(p))};
}
inline void store(u64x2& to, u64x2 a) {
  _mm_store_si128(&to.v, a.v);
}
inline u64x2 operator&(u64x2 a, u64x2 b) {
  return {_mm_and_si128(a.v, b.v)};
}
// How shift_right wants to be told to shift by n bits; in both words.
constexpr std::uint64_t shift_count(std::uint64_t n) {
  return n;
}
// Both words by as many bits.
inline u64x2 shift_right(u64x2 a, u64x2 n) {
  return {_mm_srl_epi64(a.v, n.v)};
}
// The low halves of four pairs: of their first words, and of their second.
inline void low_words(const u64x2 (&p)[4], i32x4& first, i32x4& second) {
  const auto even = [](__m128 a, __m128 b) { return _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)); };
  const auto odd = [](__m128 a, __m128 b) { return _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)); };
  const __m128 ab = even(_mm_castsi128_ps(p[0].v), _mm_castsi128_ps(p[1].v));
  const __m128 cd = even(_mm_castsi128_ps(p[2].v), _mm_castsi128_ps(p[3].v));
  first = {_mm_castps_si128(even(ab, cd))};
  second = {_mm_castps_si128(odd(ab, cd))};
}

}  // namespace marrow
