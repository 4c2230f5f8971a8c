// f32x4 with WebAssembly's 128-bit SIMD.
#pragma once

#include <wasm_simd128.h>

#include <cstddef>
#include <cstdint>

namespace marrow {

// As on NEON.
inline constexpr bool kMemoryOperands = false;
// Whether an instruction multiplies by one lane of a register.
inline constexpr bool kMultipliesByLane = false;

struct f32x4 {
  v128_t v;
};
struct mask4 {
  v128_t v;
};

inline f32x4 load(const float* p) {
  return {wasm_v128_load(p)};
}
inline f32x4 load_aligned(const float* p) {
  return {wasm_v128_load(p)};
}
inline void store(float* p, f32x4 a) {
  wasm_v128_store(p, a.v);
}
inline f32x4 splat(float s) {
  return {wasm_f32x4_splat(s)};
}
inline f32x4 lanes(float x, float y, float z, float w) {
  return {wasm_f32x4_make(x, y, z, w)};
}
inline f32x4 operator+(f32x4 a, f32x4 b) {
  return {wasm_f32x4_add(a.v, b.v)};
}
inline f32x4 operator-(f32x4 a, f32x4 b) {
  return {wasm_f32x4_sub(a.v, b.v)};
}
inline f32x4 operator*(f32x4 a, f32x4 b) {
  return {wasm_f32x4_mul(a.v, b.v)};
}
inline f32x4 operator/(f32x4 a, f32x4 b) {
  return {wasm_f32x4_div(a.v, b.v)};
}
inline f32x4 sqrt(f32x4 a) {
  return {wasm_f32x4_sqrt(a.v)};
}
inline mask4 operator<(f32x4 a, f32x4 b) {
  return {wasm_f32x4_lt(a.v, b.v)};
}
inline f32x4 select(mask4 m, f32x4 yes, f32x4 no) {
  return {wasm_v128_bitselect(yes.v, no.v, m.v)};
}
// All bits of a lane, or none.
inline mask4 load_mask(const std::uint32_t* p) {
  return {wasm_v128_load(p)};
}
inline float first_lane(f32x4 a) {
  return wasm_f32x4_extract_lane(a.v, 0);
}
// Stores the lanes in m. `to` is 16-byte aligned.
inline void store(float* to, mask4 m, f32x4 a) {
  wasm_v128_store(to, wasm_v128_bitselect(a.v, wasm_v128_load(to), m.v));
}
inline bool any(mask4 m) {
  return wasm_v128_any_true(m.v);
}
inline bool all(mask4 m) {
  return wasm_i32x4_all_true(m.v);
}
// pmin(b, a) and pmax(b, a) give the bits of SSE's minps(a, b) and maxps(a, b).
inline f32x4 lesser(f32x4 a, f32x4 b) {
  return {wasm_f32x4_pmin(b.v, a.v)};
}
inline f32x4 greater(f32x4 a, f32x4 b) {
  return {wasm_f32x4_pmax(b.v, a.v)};
}
inline f32x4 absolute(f32x4 a) {
  return {wasm_f32x4_abs(a.v)};
}
inline f32x4 only_where(mask4 m, f32x4 a) {
  return {wasm_v128_and(m.v, a.v)};
}
inline f32x4 clamp_to_unit(f32x4 a) {
  return lesser(greater(a, splat(0.0f)), splat(1.0f));
}
inline f32x4 flip(f32x4 a, f32x4 by) {
  return {wasm_v128_xor(a.v, wasm_v128_and(by.v, wasm_f32x4_const_splat(-0.0f)))};
}

template <int Lane>
inline f32x4 splat_lane(f32x4 a) {
  return {wasm_i32x4_shuffle(a.v, a.v, Lane, Lane, Lane, Lane)};
}
// Four numbers that whole vectors are multiplied by.
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
  return {wasm_v128_and(a.v, wasm_i32x4_const(0, 0, 0, -1))};
}
// a.x, a.y, a.z, 0
inline f32x4 without_w(f32x4 a) {
  return {wasm_v128_and(a.v, wasm_i32x4_const(-1, -1, -1, 0))};
}
// a.x, a.y, a.z, w.w
inline f32x4 with_w(f32x4 a, f32x4 w) {
  return {wasm_i32x4_shuffle(a.v, w.v, 0, 1, 2, 7)};
}
// a.y, a.z, a.x, a.w
inline f32x4 rotated_xyz(f32x4 a) {
  return {wasm_i32x4_shuffle(a.v, a.v, 1, 2, 0, 3)};
}
// a[X], a[Y], a[Z], a[W]
template <int X, int Y, int Z, int W>
inline f32x4 reordered(f32x4 a) {
  return {wasm_i32x4_shuffle(a.v, a.v, X, Y, Z, W)};
}
// (x + y) + (z + w), in all lanes.
inline f32x4 sum_of_lanes(f32x4 a) {
  const f32x4 pairs = a + f32x4{wasm_i32x4_shuffle(a.v, a.v, 1, 0, 3, 2)};
  return pairs + f32x4{wasm_i32x4_shuffle(pairs.v, pairs.v, 2, 3, 0, 1)};
}
// a.w, b.w, c.w, 0
inline f32x4 fourths(f32x4 a, f32x4 b, f32x4 c) {
  const v128_t ab = wasm_i32x4_shuffle(a.v, b.v, 3, 7, 3, 7);
  return without_w({wasm_i32x4_shuffle(ab, c.v, 0, 1, 7, 7)});
}
inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  const v128_t ab0 = wasm_i32x4_shuffle(a.v, b.v, 0, 4, 1, 5), ab1 = wasm_i32x4_shuffle(a.v, b.v, 2, 6, 3, 7);
  const v128_t cd0 = wasm_i32x4_shuffle(c.v, d.v, 0, 4, 1, 5), cd1 = wasm_i32x4_shuffle(c.v, d.v, 2, 6, 3, 7);
  a.v = wasm_i64x2_shuffle(ab0, cd0, 0, 2);
  b.v = wasm_i64x2_shuffle(ab0, cd0, 1, 3);
  c.v = wasm_i64x2_shuffle(ab1, cd1, 0, 2);
  d.v = wasm_i64x2_shuffle(ab1, cd1, 1, 3);
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
inline void load_xyz(const float* p, f32x4& x, f32x4& y, f32x4& z) {
  const v128_t a = wasm_v128_load(p), b = wasm_v128_load(p + 4), c = wasm_v128_load(p + 8);
  const v128_t x2y2x3y3 = wasm_i32x4_shuffle(b, c, 2, 3, 5, 6);
  const v128_t y0z0y1z1 = wasm_i32x4_shuffle(a, b, 1, 2, 4, 5);
  x.v = wasm_i32x4_shuffle(a, x2y2x3y3, 0, 3, 4, 6);
  y.v = wasm_i32x4_shuffle(y0z0y1z1, x2y2x3y3, 0, 2, 5, 7);
  z.v = wasm_i32x4_shuffle(y0z0y1z1, c, 1, 3, 4, 7);
}
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  const v128_t x0x2y0y2 = wasm_i32x4_shuffle(x.v, y.v, 0, 2, 4, 6);
  const v128_t y1y3z1z3 = wasm_i32x4_shuffle(y.v, z.v, 1, 3, 5, 7);
  const v128_t z0z2x1x3 = wasm_i32x4_shuffle(z.v, x.v, 0, 2, 5, 7);
  wasm_v128_store(p, wasm_i32x4_shuffle(x0x2y0y2, z0z2x1x3, 0, 2, 4, 6));
  wasm_v128_store(p + 4, wasm_i32x4_shuffle(y1y3z1z3, x0x2y0y2, 0, 2, 5, 7));
  wasm_v128_store(p + 8, wasm_i32x4_shuffle(z0z2x1x3, y1y3z1z3, 1, 3, 5, 7));
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
  v128_t v;
};
struct u64x2 {
  v128_t v;
};

inline i32x4 splat_int(std::int32_t s) {
  return {wasm_i32x4_splat(s)};
}
inline i32x4 operator+(i32x4 a, i32x4 b) {
  return {wasm_i32x4_add(a.v, b.v)};
}
inline i32x4 operator&(i32x4 a, i32x4 b) {
  return {wasm_v128_and(a.v, b.v)};
}
template <int Bits>
inline i32x4 shift_left(i32x4 a) {
  return {wasm_i32x4_shl(a.v, Bits)};
}
inline i32x4 load_aligned(const std::uint32_t* p) {
  return {wasm_v128_load(p)};
}
// p is 16-byte aligned. For reading single bytes back.
inline void store(std::byte* p, i32x4 a) {
  wasm_v128_store(p, a.v);
}
inline f32x4 to_float(i32x4 a) {
  return {wasm_f32x4_convert_i32x4(a.v)};
}
// Four whole numbers, whatever their alignment.
inline f32x4 load_int16(const std::int16_t* p) {
  return {wasm_f32x4_convert_i32x4(wasm_i32x4_load16x4(p))};
}
inline f32x4 bits_as_float(i32x4 a) {
  return {a.v};
}
inline i32x4 float_as_bits(f32x4 a) {
  return {a.v};
}
// Sixty-four bits from each of two places, whatever their alignment.
inline u64x2 load_pair(const std::byte* a, const std::byte* b) {
  return {wasm_v128_load64_lane(b, wasm_v128_load64_zero(a), 1)};
}
// From one place; the second word is 0.
inline u64x2 load_one(const std::byte* p) {
  return {wasm_v128_load64_zero(p)};
}
// The first word of each.
inline u64x2 firsts(u64x2 a, u64x2 b) {
  return {wasm_i64x2_shuffle(a.v, b.v, 0, 2)};
}
inline u64x2 load_aligned(const std::uint64_t* p) {
  return {wasm_v128_load(p)};
}
inline u64x2 operator&(u64x2 a, u64x2 b) {
  return {wasm_v128_and(a.v, b.v)};
}
// The count that makes shift_right() shift by n bits. Tables hold it in both words of a vector.
constexpr std::uint64_t shift_count(std::uint64_t n) {
  return n;
}
// Shifts both words by the same number of bits. n: shift_count() in both words.
inline u64x2 shift_right(u64x2 a, const std::uint64_t* n) {
  return {wasm_u64x2_shr(a.v, static_cast<std::uint32_t>(*n))};
}
inline i32x4 words(u64x2 a) {
  return {a.v};
}
// Four words, whatever their alignment.
inline i32x4 load_words(const std::byte* p) {
  return {wasm_v128_load(p)};
}
// The first and third words of a and of b.
inline i32x4 even(i32x4 a, i32x4 b) {
  return {wasm_i32x4_shuffle(a.v, b.v, 0, 2, 4, 6)};
}
// The second and fourth.
inline i32x4 odd(i32x4 a, i32x4 b) {
  return {wasm_i32x4_shuffle(a.v, b.v, 1, 3, 5, 7)};
}

}  // namespace marrow
