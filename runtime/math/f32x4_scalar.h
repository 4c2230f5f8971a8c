// f32x4 in plain C++: the reference that the SIMD backends must equal bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/builtins.h"

namespace marrow {

// As on NEON.
inline constexpr bool kMemoryOperands = false;
// Whether an instruction multiplies by one lane of a register.
inline constexpr bool kMultipliesByLane = false;

struct f32x4 {
  float v[4];
};
struct mask4 {
  bool v[4];
};

template <class Operation>
inline f32x4 each_lane(Operation operation) {
  return {{operation(0), operation(1), operation(2), operation(3)}};
}

inline f32x4 load(const float* p) {
  return {{p[0], p[1], p[2], p[3]}};
}
inline f32x4 load_aligned(const float* p) {
  return load(p);
}
inline void store(float* p, f32x4 a) {
  for (int i = 0; i < 4; ++i) p[i] = a.v[i];
}
inline f32x4 splat(float s) {
  return {{s, s, s, s}};
}
inline f32x4 lanes(float x, float y, float z, float w) {
  return {{x, y, z, w}};
}
inline f32x4 operator+(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return a.v[i] + b.v[i]; });
}
inline f32x4 operator-(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return a.v[i] - b.v[i]; });
}
inline f32x4 operator*(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return a.v[i] * b.v[i]; });
}
inline f32x4 operator/(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return a.v[i] / b.v[i]; });
}
inline f32x4 sqrt(f32x4 a) {
  return each_lane([&](int i) { return square_root(a.v[i]); });
}
inline mask4 operator<(f32x4 a, f32x4 b) {
  return {{a.v[0] < b.v[0], a.v[1] < b.v[1], a.v[2] < b.v[2], a.v[3] < b.v[3]}};
}
inline f32x4 select(mask4 m, f32x4 yes, f32x4 no) {
  return each_lane([&](int i) { return m.v[i] ? yes.v[i] : no.v[i]; });
}
// All bits of a lane, or none.
inline mask4 load_mask(const std::uint32_t* p) {
  return {{p[0] != 0, p[1] != 0, p[2] != 0, p[3] != 0}};
}
inline float first_lane(f32x4 a) {
  return a.v[0];
}
// Stores the lanes in m. `to` is 16-byte aligned.
inline void store(float* to, mask4 m, f32x4 a) {
  for (int i = 0; i < 4; ++i) to[i] = m.v[i] ? a.v[i] : to[i];
}
inline bool any(mask4 m) {
  return m.v[0] || m.v[1] || m.v[2] || m.v[3];
}
inline bool all(mask4 m) {
  return m.v[0] && m.v[1] && m.v[2] && m.v[3];
}
inline f32x4 lesser(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline f32x4 greater(f32x4 a, f32x4 b) {
  return each_lane([&](int i) { return b.v[i] < a.v[i] ? a.v[i] : b.v[i]; });
}
inline f32x4 absolute(f32x4 a) {
  return each_lane([&](int i) { return without_sign(a.v[i]); });
}
inline f32x4 only_where(mask4 m, f32x4 a) {
  return each_lane([&](int i) { return m.v[i] ? a.v[i] : 0.0f; });
}
inline f32x4 clamp_to_unit(f32x4 a) {
  return each_lane([&](int i) { return !(0.0f < a.v[i]) ? 0.0f : a.v[i] < 1.0f ? a.v[i] : 1.0f; });
}
inline f32x4 flip(f32x4 a, f32x4 by) {
  return each_lane([&](int i) { return has_sign(by.v[i]) ? -a.v[i] : a.v[i]; });
}

template <int Lane>
inline f32x4 splat_lane(f32x4 a) {
  return splat(a.v[Lane]);
}
// Four numbers that whole vectors are multiplied by.
struct Factors {
  f32x4 row;
};
inline Factors factors(f32x4 a) {
  return {a};
}
template <int Lane>
inline f32x4 times(f32x4 v, const Factors& f) {
  return v * splat(f.row.v[Lane]);
}

// 0, 0, 0, a.w
inline f32x4 only_w(f32x4 a) {
  return {{0.0f, 0.0f, 0.0f, a.v[3]}};
}
// a.x, a.y, a.z, 0
inline f32x4 without_w(f32x4 a) {
  return {{a.v[0], a.v[1], a.v[2], 0.0f}};
}
// a.x, a.y, a.z, w.w
inline f32x4 with_w(f32x4 a, f32x4 w) {
  return {{a.v[0], a.v[1], a.v[2], w.v[3]}};
}
// a.y, a.z, a.x, a.w
inline f32x4 rotated_xyz(f32x4 a) {
  return {{a.v[1], a.v[2], a.v[0], a.v[3]}};
}
// a[X], a[Y], a[Z], a[W]
template <int X, int Y, int Z, int W>
inline f32x4 reordered(f32x4 a) {
  return {{a.v[X], a.v[Y], a.v[Z], a.v[W]}};
}
// (x + y) + (z + w), in all lanes.
inline f32x4 sum_of_lanes(f32x4 a) {
  return splat((a.v[0] + a.v[1]) + (a.v[2] + a.v[3]));
}
// a.w, b.w, c.w, 0
inline f32x4 fourths(f32x4 a, f32x4 b, f32x4 c) {
  return {{a.v[3], b.v[3], c.v[3], 0.0f}};
}

inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  const f32x4 rows[4] = {a, b, c, d};
  f32x4* const columns[4] = {&a, &b, &c, &d};
  for (int i = 0; i < 4; ++i) *columns[i] = each_lane([&](int j) { return rows[j].v[i]; });
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
inline void load_xyz(const float* p, f32x4& x, f32x4& y, f32x4& z) {
  x = each_lane([&](int i) { return p[3 * i]; });
  y = each_lane([&](int i) { return p[3 * i + 1]; });
  z = each_lane([&](int i) { return p[3 * i + 2]; });
}
inline void store_xyz(float* p, f32x4 x, f32x4 y, f32x4 z) {
  for (int i = 0; i < 4; ++i) {
    p[3 * i] = x.v[i];
    p[3 * i + 1] = y.v[i];
    p[3 * i + 2] = z.v[i];
  }
}

// Sixteen floats: x0 y0 z0 w0 x1 y1 z1 w1 …
inline void store_xyzw(float* p, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  for (int i = 0; i < 4; ++i) {
    p[4 * i] = x.v[i];
    p[4 * i + 1] = y.v[i];
    p[4 * i + 2] = z.v[i];
    p[4 * i + 3] = w.v[i];
  }
}

// Four 32-bit and two 64-bit words, for unpacking.
struct i32x4 {
  std::int32_t v[4];
};
struct alignas(16) u64x2 {
  std::uint64_t v[2];
};

template <class Operation>
inline i32x4 each_int(Operation operation) {
  return {{operation(0), operation(1), operation(2), operation(3)}};
}

inline i32x4 splat_int(std::int32_t s) {
  return {{s, s, s, s}};
}
inline i32x4 operator+(i32x4 a, i32x4 b) {
  return each_int([&](int i) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a.v[i]) + static_cast<std::uint32_t>(b.v[i]));
  });
}
inline i32x4 operator&(i32x4 a, i32x4 b) {
  return each_int([&](int i) { return a.v[i] & b.v[i]; });
}
template <int Bits>
inline i32x4 shift_left(i32x4 a) {
  return each_int([&](int i) { return static_cast<std::int32_t>(static_cast<std::uint32_t>(a.v[i]) << Bits); });
}
inline i32x4 load_aligned(const std::uint32_t* p) {
  i32x4 out;
  std::memcpy(out.v, p, 16);
  return out;
}
// p is 16-byte aligned. For reading single bytes back.
inline void store(std::byte* p, i32x4 a) {
  std::memcpy(p, a.v, 16);
}
inline f32x4 to_float(i32x4 a) {
  return each_lane([&](int i) { return static_cast<float>(a.v[i]); });
}
// Four whole numbers, whatever their alignment.
inline f32x4 load_int16(const std::int16_t* p) {
  return each_lane([&](int i) { return static_cast<float>(p[i]); });
}
inline f32x4 bits_as_float(i32x4 a) {
  return each_lane([&](int i) { return bit_cast<float>(a.v[i]); });
}
inline i32x4 float_as_bits(f32x4 a) {
  return each_int([&](int i) { return bit_cast<std::int32_t>(a.v[i]); });
}
// Sixty-four bits from each of two places, whatever their alignment.
inline u64x2 load_pair(const std::byte* a, const std::byte* b) {
  u64x2 out;
  std::memcpy(out.v, a, 8);
  std::memcpy(out.v + 1, b, 8);
  return out;
}
// From one place; the second word is 0.
inline u64x2 load_one(const std::byte* p) {
  u64x2 out = {};
  std::memcpy(out.v, p, 8);
  return out;
}
// The first word of each.
inline u64x2 firsts(u64x2 a, u64x2 b) {
  return {{a.v[0], b.v[0]}};
}
inline u64x2 load_aligned(const std::uint64_t* p) {
  return {{p[0], p[1]}};
}
inline u64x2 operator&(u64x2 a, u64x2 b) {
  return {{a.v[0] & b.v[0], a.v[1] & b.v[1]}};
}
// The count that makes shift_right() shift by n bits. Tables hold it in both words of a vector.
constexpr std::uint64_t shift_count(std::uint64_t n) {
  return n;
}
// Shifts both words by the same number of bits. n: shift_count() in both words.
inline u64x2 shift_right(u64x2 a, const std::uint64_t* n) {
  return {{a.v[0] >> n[0], a.v[1] >> n[0]}};
}
inline i32x4 words(u64x2 a) {
  return bit_cast<i32x4>(a);
}
// Four words, whatever their alignment.
inline i32x4 load_words(const std::byte* p) {
  i32x4 out;
  std::memcpy(out.v, p, 16);
  return out;
}
// The first and third words of a and of b.
inline i32x4 even(i32x4 a, i32x4 b) {
  return {{a.v[0], a.v[2], b.v[0], b.v[2]}};
}
// The second and fourth.
inline i32x4 odd(i32x4 a, i32x4 b) {
  return {{a.v[1], a.v[3], b.v[1], b.v[3]}};
}

}  // namespace marrow
