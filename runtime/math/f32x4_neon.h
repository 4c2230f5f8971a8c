// f32x4 with AArch64 NEON.
#pragma once

#include <arm_neon.h>

#include <cstddef>
#include <cstdint>

namespace marrow {

// Operands come from registers only.
inline constexpr bool kMemoryOperands = false;
// Whether an instruction multiplies by one lane of a register.
inline constexpr bool kMultipliesByLane = true;

struct f32x4 {
  float32x4_t v;
};
struct mask4 {
  uint32x4_t v;
};

inline f32x4 load(const float* p) {
  return {vld1q_f32(p)};
}
inline f32x4 load_aligned(const float* p) {
  return {vld1q_f32(p)};
}
inline void store(float* p, f32x4 a) {
  vst1q_f32(p, a.v);
}
inline f32x4 splat(float s) {
  return {vdupq_n_f32(s)};
}
inline f32x4 lanes(float x, float y, float z, float w) {
  return {vsetq_lane_f32(w, vsetq_lane_f32(z, vsetq_lane_f32(y, vdupq_n_f32(x), 1), 2), 3)};
}
inline f32x4 operator+(f32x4 a, f32x4 b) {
  return {vaddq_f32(a.v, b.v)};
}
inline f32x4 operator-(f32x4 a, f32x4 b) {
  return {vsubq_f32(a.v, b.v)};
}
inline f32x4 operator*(f32x4 a, f32x4 b) {
  return {vmulq_f32(a.v, b.v)};
}
inline f32x4 operator/(f32x4 a, f32x4 b) {
  return {vdivq_f32(a.v, b.v)};
}
inline f32x4 sqrt(f32x4 a) {
  return {vsqrtq_f32(a.v)};
}
inline mask4 operator<(f32x4 a, f32x4 b) {
  return {vcltq_f32(a.v, b.v)};
}
inline f32x4 select(mask4 m, f32x4 yes, f32x4 no) {
  return {vbslq_f32(m.v, yes.v, no.v)};
}
// All bits of a lane, or none.
inline mask4 load_mask(const std::uint32_t* p) {
  return {vld1q_u32(p)};
}
inline float first_lane(f32x4 a) {
  return vgetq_lane_f32(a.v, 0);
}
// Stores the lanes in m. `to` is 16-byte aligned.
inline void store(float* to, mask4 m, f32x4 a) {
  vst1q_f32(to, vbslq_f32(m.v, a.v, vld1q_f32(to)));
}
inline bool any(mask4 m) {
  return vmaxvq_u32(m.v) != 0;
}
inline bool all(mask4 m) {
  return vminvq_u32(m.v) != 0;
}
inline f32x4 lesser(f32x4 a, f32x4 b) {
  return {vminq_f32(a.v, b.v)};
}
inline f32x4 greater(f32x4 a, f32x4 b) {
  return {vmaxq_f32(a.v, b.v)};
}
inline f32x4 absolute(f32x4 a) {
  return {vabsq_f32(a.v)};
}
inline f32x4 only_where(mask4 m, f32x4 a) {
  return {vreinterpretq_f32_u32(vandq_u32(m.v, vreinterpretq_u32_f32(a.v)))};
}
inline f32x4 clamp_to_unit(f32x4 a) {
  const uint32x4_t positive = vandq_u32(vreinterpretq_u32_f32(a.v), vcgtzq_f32(a.v));
  return {vminq_f32(vreinterpretq_f32_u32(positive), vdupq_n_f32(1.0f))};
}
inline f32x4 flip(f32x4 a, f32x4 by) {
  const uint32x4_t sign = vandq_u32(vreinterpretq_u32_f32(by.v), vdupq_n_u32(0x80000000u));
  return {vreinterpretq_f32_u32(veorq_u32(vreinterpretq_u32_f32(a.v), sign))};
}

template <int Lane>
inline f32x4 splat_lane(f32x4 a) {
  return {vdupq_laneq_f32(a.v, Lane)};
}
// Four numbers that whole vectors are multiplied by: multiplication takes a lane of a vector as it is.
struct Factors {
  f32x4 row;
};
inline Factors factors(f32x4 a) {
  return {a};
}
template <int Lane>
inline f32x4 times(f32x4 v, const Factors& f) {
  return {vmulq_laneq_f32(v.v, f.row.v, Lane)};
}
// Tells the compiler that the vector may have changed, so that it keeps no copies of single lanes.
inline void stay_whole([[maybe_unused]] f32x4& a) {
#if defined(__GNUC__)
  asm("" : "+w"(a.v));
#endif
}
inline void stay_whole(Factors& f) {
  stay_whole(f.row);
}

// 0, 0, 0, a.w
inline f32x4 only_w(f32x4 a) {
  const uint32x4_t mask = {0, 0, 0, 0xFFFFFFFFu};
  return {vreinterpretq_f32_u32(vandq_u32(vreinterpretq_u32_f32(a.v), mask))};
}
// a.x, a.y, a.z, 0
inline f32x4 without_w(f32x4 a) {
  return {vsetq_lane_f32(0.0f, a.v, 3)};
}
// a.x, a.y, a.z, w.w
inline f32x4 with_w(f32x4 a, f32x4 w) {
  return {vcopyq_laneq_f32(a.v, 3, w.v, 3)};
}
// a.y, a.z, a.x, a.w
inline f32x4 rotated_xyz(f32x4 a) {
  const uint8x16_t order = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 12, 13, 14, 15};
  return {vreinterpretq_f32_u8(vqtbl1q_u8(vreinterpretq_u8_f32(a.v), order))};
}
// a[X], a[Y], a[Z], a[W]
template <int X, int Y, int Z, int W>
inline f32x4 reordered(f32x4 a) {
  constexpr uint8x16_t order = {4 * X, 4 * X + 1, 4 * X + 2, 4 * X + 3, 4 * Y, 4 * Y + 1, 4 * Y + 2, 4 * Y + 3,
                                4 * Z, 4 * Z + 1, 4 * Z + 2, 4 * Z + 3, 4 * W, 4 * W + 1, 4 * W + 2, 4 * W + 3};
  return {vreinterpretq_f32_u8(vqtbl1q_u8(vreinterpretq_u8_f32(a.v), order))};
}
// (x + y) + (z + w), in all lanes.
inline f32x4 sum_of_lanes(f32x4 a) {
  const float32x4_t pairs = vpaddq_f32(a.v, a.v);
  return {vpaddq_f32(pairs, pairs)};
}
#define MARROW_F32X4_SUMS_THREE 1  // else f32x4.h does
// {Σ a, Σ b, Σ c, Σ c}, each as sum_of_lanes(); w of a, b and c must be 0.
inline f32x4 three_sums(f32x4 a, f32x4 b, f32x4 c) {
  return {vpaddq_f32(vpaddq_f32(a.v, b.v), vpaddq_f32(c.v, c.v))};
}
// a.w, b.w, c.w, 0
inline f32x4 fourths(f32x4 a, f32x4 b, f32x4 c) {
  const float64x2_t ab = vreinterpretq_f64_f32(vzip2q_f32(a.v, b.v));  // z, z, w, w
  const float64x2_t c0 = vreinterpretq_f64_f32(vzip2q_f32(c.v, vdupq_n_f32(0.0f)));
  return {vreinterpretq_f32_f64(vzip2q_f64(ab, c0))};
}

inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  const float64x2_t ab0 = vreinterpretq_f64_f32(vtrn1q_f32(a.v, b.v)),
                    ab1 = vreinterpretq_f64_f32(vtrn2q_f32(a.v, b.v));
  const float64x2_t cd0 = vreinterpretq_f64_f32(vtrn1q_f32(c.v, d.v)),
                    cd1 = vreinterpretq_f64_f32(vtrn2q_f32(c.v, d.v));
  a.v = vreinterpretq_f32_f64(vtrn1q_f64(ab0, cd0));
  b.v = vreinterpretq_f32_f64(vtrn1q_f64(ab1, cd1));
  c.v = vreinterpretq_f32_f64(vtrn2q_f64(ab0, cd0));
  d.v = vreinterpretq_f32_f64(vtrn2q_f64(ab1, cd1));
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
inline void load_xyz(const float* p, f32x4& x, f32x4& y, f32x4& z) {
  const float32x4x3_t xyz = vld3q_f32(p);
  x.v = xyz.val[0];
  y.v = xyz.val[1];
  z.v = xyz.val[2];
}
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  const float32x4x3_t xyz = {{x.v, y.v, z.v}};  // a name, since clang's vst3q_f32 is a macro
  vst3q_f32(p, xyz);
}

// Sixteen floats: x0 y0 z0 w0 x1 y1 z1 w1 …
inline void store_xyzw(float* p, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  const float32x4x4_t xyzw = {{x.v, y.v, z.v, w.v}};
  vst4q_f32(p, xyzw);
}

// Four 32-bit and two 64-bit words, for unpacking.
struct i32x4 {
  int32x4_t v;
};
struct u64x2 {
  uint64x2_t v;
};

inline i32x4 splat_int(std::int32_t s) {
  return {vdupq_n_s32(s)};
}
inline i32x4 operator+(i32x4 a, i32x4 b) {
  return {vaddq_s32(a.v, b.v)};
}
inline i32x4 operator&(i32x4 a, i32x4 b) {
  return {vandq_s32(a.v, b.v)};
}
template <int Bits>
inline i32x4 shift_left(i32x4 a) {
  return {vshlq_n_s32(a.v, Bits)};
}
inline i32x4 load_aligned(const std::uint32_t* p) {
  return {vreinterpretq_s32_u32(vld1q_u32(p))};
}
// p is 16-byte aligned. For reading single bytes back.
inline void store(std::byte* p, i32x4 a) {
  vst1q_u8(reinterpret_cast<std::uint8_t*>(p), vreinterpretq_u8_s32(a.v));
}
inline f32x4 to_float(i32x4 a) {
  return {vcvtq_f32_s32(a.v)};
}
// Four whole numbers, whatever their alignment.
inline f32x4 load_int16(const std::int16_t* p) {
  return {vcvtq_f32_s32(vmovl_s16(vld1_s16(p)))};
}
inline f32x4 bits_as_float(i32x4 a) {
  return {vreinterpretq_f32_s32(a.v)};
}
inline i32x4 float_as_bits(f32x4 a) {
  return {vreinterpretq_s32_f32(a.v)};
}
// Sixty-four bits from each of two places, whatever their alignment.
inline u64x2 load_pair(const std::byte* a, const std::byte* b) {
  return {vreinterpretq_u64_u8(vcombine_u8(vld1_u8(reinterpret_cast<const std::uint8_t*>(a)),
                                           vld1_u8(reinterpret_cast<const std::uint8_t*>(b))))};
}
// From one place; the second word is 0.
inline u64x2 load_one(const std::byte* p) {
  return {vreinterpretq_u64_u8(vcombine_u8(vld1_u8(reinterpret_cast<const std::uint8_t*>(p)), vdup_n_u8(0)))};
}
// The first word of each.
inline u64x2 firsts(u64x2 a, u64x2 b) {
  return {vzip1q_u64(a.v, b.v)};
}
inline u64x2 load_aligned(const std::uint64_t* p) {
  return {vld1q_u64(p)};
}
inline u64x2 operator&(u64x2 a, u64x2 b) {
  return {vandq_u64(a.v, b.v)};
}
// The count that makes shift_right() shift by n bits. Tables hold it in both words of a vector.
constexpr std::uint64_t shift_count(std::uint64_t n) {
  return ~n + 1;  // NEON shifts left
}
// Shifts both words by the same number of bits. n: shift_count() in both words.
inline u64x2 shift_right(u64x2 a, const std::uint64_t* n) {
  return {vshlq_u64(a.v, vreinterpretq_s64_u64(vld1q_u64(n)))};
}
inline i32x4 words(u64x2 a) {
  return {vreinterpretq_s32_u64(a.v)};
}
// Four words, whatever their alignment.
inline i32x4 load_words(const std::byte* p) {
  return {vreinterpretq_s32_u8(vld1q_u8(reinterpret_cast<const std::uint8_t*>(p)))};
}
// The first and third words of a and of b.
inline i32x4 even(i32x4 a, i32x4 b) {
  return {vuzp1q_s32(a.v, b.v)};
}
// The second and fourth.
inline i32x4 odd(i32x4 a, i32x4 b) {
  return {vuzp2q_s32(a.v, b.v)};
}

}  // namespace marrow
