// f32x4 with AArch64 NEON.
#pragma once

#include <arm_neon.h>

#include <cstdint>

namespace marrow {

// Operands come from registers only.
inline constexpr bool kMemoryOperands = false;

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
inline f32x4 from_ints(const std::int32_t* p) {
  return {vcvtq_f32_s32(vld1q_s32(p))};
}
inline void store(float* p, f32x4 a) {
  vst1q_f32(p, a.v);
}
inline f32x4 splat(float s) {
  return {vdupq_n_f32(s)};
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
inline bool any(mask4 m) {
  return vmaxvq_u32(m.v) != 0;
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

// 0, 0, 0, a.w
inline f32x4 only_w(f32x4 a) {
  const uint32x4_t mask = {0, 0, 0, 0xFFFFFFFFu};
  return {vreinterpretq_f32_u32(vandq_u32(vreinterpretq_u32_f32(a.v), mask))};
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
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  const float32x4x3_t xyz = {{x.v, y.v, z.v}};  // a name, since clang's vst3q_f32 is a macro
  vst3q_f32(p, xyz);
}

// Sixteen floats: x0 y0 z0 w0 x1 y1 z1 w1 …
inline void store_xyzw(float* p, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  const float32x4x4_t xyzw = {{x.v, y.v, z.v, w.v}};
  vst4q_f32(p, xyzw);
}

}  // namespace marrow
