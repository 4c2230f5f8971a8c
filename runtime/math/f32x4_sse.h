// f32x4 with SSE2.
#pragma once

#include <emmintrin.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace marrow {

// Instructions take an operand from memory: what is used once need not be loaded first.
inline constexpr bool kMemoryOperands = true;
// Whether an instruction multiplies by one lane of a register.
inline constexpr bool kMultipliesByLane = false;

struct f32x4 {
  __m128 v;
};
struct mask4 {
  __m128 v;
};

inline f32x4 load(const float* p) {
  return {_mm_loadu_ps(p)};
}
// p is 16-byte aligned, so the load may be folded into the instruction that uses it.
inline f32x4 load_aligned(const float* p) {
  return {_mm_load_ps(p)};
}
inline void store(float* p, f32x4 a) {
  _mm_storeu_ps(p, a.v);
}
inline f32x4 splat(float s) {
  return {_mm_set1_ps(s)};
}
inline f32x4 lanes(float x, float y, float z, float w) {
  return {_mm_setr_ps(x, y, z, w)};
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
// All bits of a lane, or none.
inline mask4 load_mask(const std::uint32_t* p) {
  return {_mm_load_ps(reinterpret_cast<const float*>(p))};
}
inline float first_lane(f32x4 a) {
  return _mm_cvtss_f32(a.v);
}
// Stores the lanes in m. `to` is 16-byte aligned.
inline void store(float* to, mask4 m, f32x4 a) {
  const __m128 change = _mm_and_ps(_mm_xor_ps(a.v, _mm_load_ps(to)), m.v);
  _mm_store_ps(to, _mm_xor_ps(change, _mm_load_ps(to)));
}
inline bool any(mask4 m) {
  return _mm_movemask_ps(m.v) != 0;
}
inline bool all(mask4 m) {
  return _mm_movemask_ps(m.v) == 15;
}
// If one operand is NaN, or both are zeros, the result may be either operand.
inline f32x4 lesser(f32x4 a, f32x4 b) {
  return {_mm_min_ps(a.v, b.v)};
}
inline f32x4 greater(f32x4 a, f32x4 b) {
  return {_mm_max_ps(a.v, b.v)};
}
inline f32x4 absolute(f32x4 a) {
  return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)};
}
// a where m holds, else 0.
inline f32x4 only_where(mask4 m, f32x4 a) {
  return {_mm_and_ps(m.v, a.v)};
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
// Four numbers that whole vectors are multiplied by. Each fills all lanes, which SSE multiplies fastest.
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
// a.x, a.y, a.z, 0
inline f32x4 without_w(f32x4 a) {
  return {_mm_and_ps(a.v, _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0)))};
}
template <int Order>
inline f32x4 shuffled(f32x4 a) {
  return {_mm_castsi128_ps(_mm_shuffle_epi32(_mm_castps_si128(a.v), Order))};
}
// a.x, a.y, a.z, w.w
inline f32x4 with_w(f32x4 a, f32x4 w) {
  return {_mm_or_ps(without_w(a).v, only_w(w).v)};
}
// a.y, a.z, a.x, a.w
inline f32x4 rotated_xyz(f32x4 a) {
  return shuffled<_MM_SHUFFLE(3, 0, 2, 1)>(a);
}
// a[X], a[Y], a[Z], a[W]
template <int X, int Y, int Z, int W>
inline f32x4 reordered(f32x4 a) {
  return shuffled<_MM_SHUFFLE(W, Z, Y, X)>(a);
}
// (x + y) + (z + w), in all lanes.
inline f32x4 sum_of_lanes(f32x4 a) {
  const f32x4 pairs = a + shuffled<_MM_SHUFFLE(2, 3, 0, 1)>(a);
  return pairs + shuffled<_MM_SHUFFLE(1, 0, 3, 2)>(pairs);
}
#define MARROW_F32X4_SUMS_THREE 1  // else f32x4.h does
// {Σ a, Σ b, Σ c, Σ c}, each as sum_of_lanes(); w of a, b and c must be 0.
inline f32x4 three_sums(f32x4 a, f32x4 b, f32x4 c) {
  const __m128 low = _mm_unpacklo_ps(a.v, b.v), high = _mm_unpackhi_ps(a.v, b.v);  // x, x, y, y; z, z, w, w
  const f32x4 x = {_mm_shuffle_ps(low, c.v, _MM_SHUFFLE(0, 0, 1, 0))},
              y = {_mm_shuffle_ps(low, c.v, _MM_SHUFFLE(1, 1, 3, 2))},
              z = {_mm_shuffle_ps(high, c.v, _MM_SHUFFLE(2, 2, 1, 0))};
  return x + y + z;
}
#define MARROW_F32X4_SUMS 1  // else f32x4.h does
// {x.x + x.y + x.z, the same of y, the same of z, 0}, each summed from left to right.
inline f32x4 sums(f32x4 x, f32x4 y, f32x4 z) {
  return without_w(three_sums(x, y, z));
}
// a.w, b.w, c.w, 0
inline f32x4 fourths(f32x4 a, f32x4 b, f32x4 c) {
  const __m128 ab = _mm_unpackhi_ps(a.v, b.v);  // z, z, w, w
  return without_w({_mm_shuffle_ps(ab, c.v, _MM_SHUFFLE(3, 3, 3, 2))});
}
[[gnu::always_inline]] inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  _MM_TRANSPOSE4_PS(a.v, b.v, c.v, d.v);
}

#define MARROW_F32X4_LOADS_TRANSPOSED 1  // else f32x4.h does
// Loads four vectors, each 16-byte aligned, and transposes them. Loading halves saves the copies that shuffles need.
inline void load_transposed(const float* a, const float* b, const float* c, const float* d, f32x4& x, f32x4& y,
                            f32x4& z, f32x4& w) {
  const auto halves = [](const float* low, const float* high) {
    const __m128i first = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(low));
    return _mm_loadh_pi(_mm_castsi128_ps(first), reinterpret_cast<const __m64*>(high));
  };
  const __m128 ab = halves(a, b), cd = halves(c, d), ab2 = halves(a + 2, b + 2), cd2 = halves(c + 2, d + 2);
  x.v = _mm_shuffle_ps(ab, cd, _MM_SHUFFLE(2, 0, 2, 0));
  y.v = _mm_shuffle_ps(ab, cd, _MM_SHUFFLE(3, 1, 3, 1));
  z.v = _mm_shuffle_ps(ab2, cd2, _MM_SHUFFLE(2, 0, 2, 0));
  w.v = _mm_shuffle_ps(ab2, cd2, _MM_SHUFFLE(3, 1, 3, 1));
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
inline void load_xyz(const float* p, f32x4& x, f32x4& y, f32x4& z) {
  const __m128 a = _mm_loadu_ps(p), b = _mm_loadu_ps(p + 4), c = _mm_loadu_ps(p + 8);
  const __m128 x2y2x3y3 = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));
  const __m128 y0z0y1z1 = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));
  x.v = _mm_shuffle_ps(a, x2y2x3y3, _MM_SHUFFLE(2, 0, 3, 0));
  y.v = _mm_shuffle_ps(y0z0y1z1, x2y2x3y3, _MM_SHUFFLE(3, 1, 2, 0));
  z.v = _mm_shuffle_ps(y0z0y1z1, c, _MM_SHUFFLE(3, 0, 3, 1));
}
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  const __m128 x0x2y0y2 = _mm_shuffle_ps(x.v, y.v, _MM_SHUFFLE(2, 0, 2, 0));
  const __m128 y1y3z1z3 = _mm_shuffle_ps(y.v, z.v, _MM_SHUFFLE(3, 1, 3, 1));
  const __m128 z0z2x1x3 = _mm_shuffle_ps(z.v, x.v, _MM_SHUFFLE(3, 1, 2, 0));
  _mm_storeu_ps(p, _mm_shuffle_ps(x0x2y0y2, z0z2x1x3, _MM_SHUFFLE(2, 0, 2, 0)));
  _mm_storeu_ps(p + 4, _mm_shuffle_ps(y1y3z1z3, x0x2y0y2, _MM_SHUFFLE(3, 1, 2, 0)));
  _mm_storeu_ps(p + 8, _mm_shuffle_ps(z0z2x1x3, y1y3z1z3, _MM_SHUFFLE(3, 1, 3, 1)));
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
inline i32x4 load_aligned(const std::uint32_t* p) {
  return {_mm_load_si128(reinterpret_cast<const __m128i*>(p))};
}
// p is 16-byte aligned. For reading single bytes back.
inline void store(std::byte* p, i32x4 a) {
  __m128i* const to = reinterpret_cast<__m128i*>(p);
#if defined(__GNUC__) && !defined(__clang__) && !defined(__AVX__)
  // GCC would shuffle each byte out of the register instead of loading it. With this asm and the one in shift_right()
  // `sample/*` takes 4 to 6 % less.
  asm("movdqa %1, %0" : "=m"(*to) : "x"(a.v));
#else
  _mm_store_si128(to, a.v);
#endif
}
inline f32x4 to_float(i32x4 a) {
  return {_mm_cvtepi32_ps(a.v)};
}
// Four whole numbers, whatever their alignment.
inline f32x4 load_int16(const std::int16_t* p) {
  const __m128i v = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p));
  return {_mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(v, v), 16))};
}
inline f32x4 bits_as_float(i32x4 a) {
  return {_mm_castsi128_ps(a.v)};
}
inline i32x4 float_as_bits(f32x4 a) {
  return {_mm_castps_si128(a.v)};
}
// Sixty-four bits from each of two places, whatever their alignment.
inline u64x2 load_pair(const std::byte* a, const std::byte* b) {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(a));
  return {_mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(b)))};
}
// From one place; the second word is 0.
inline u64x2 load_one(const std::byte* p) {
  return {_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p))};
}
// The first word of each.
inline u64x2 firsts(u64x2 a, u64x2 b) {
  return {_mm_unpacklo_epi64(a.v, b.v)};
}
inline u64x2 load_aligned(const std::uint64_t* p) {
  return {_mm_load_si128(reinterpret_cast<const __m128i*>(p))};
}
inline u64x2 operator&(u64x2 a, u64x2 b) {
  return {_mm_and_si128(a.v, b.v)};
}
// The count that makes shift_right() shift by n bits. Tables hold it in both words of a vector.
constexpr std::uint64_t shift_count(std::uint64_t n) {
  return n;
}
// Shifts both words by the same number of bits. n: shift_count() in both words.
inline u64x2 shift_right(u64x2 a, const std::uint64_t* n) {
  const __m128i* const count = reinterpret_cast<const __m128i*>(n);
#if defined(__GNUC__) && !defined(__clang__) && !defined(__AVX__)
  // GCC cannot fold this load, and sends it through a general register.
  asm("psrlq %1, %0" : "+x"(a.v) : "m"(*count));
  return a;
#else
  return {_mm_srl_epi64(a.v, _mm_load_si128(count))};
#endif
}
inline i32x4 words(u64x2 a) {
  return {a.v};
}
// Four words, whatever their alignment.
inline i32x4 load_words(const std::byte* p) {
  return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))};
}
// The first and third words of a and of b.
inline i32x4 even(i32x4 a, i32x4 b) {
  const __m128 v = _mm_shuffle_ps(_mm_castsi128_ps(a.v), _mm_castsi128_ps(b.v), _MM_SHUFFLE(2, 0, 2, 0));
  return {_mm_castps_si128(v)};
}
// The second and fourth.
inline i32x4 odd(i32x4 a, i32x4 b) {
  const __m128 v = _mm_shuffle_ps(_mm_castsi128_ps(a.v), _mm_castsi128_ps(b.v), _MM_SHUFFLE(3, 1, 3, 1));
  return {_mm_castps_si128(v)};
}

}  // namespace marrow
