// f32x4 in plain C++: the reference that the SIMD backends must equal bit for bit.
#pragma once

#include <cstdint>

namespace marrow {

// As on NEON.
inline constexpr bool kMemoryOperands = false;

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
inline f32x4 from_ints(const std::int32_t* p) {
  return {{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), static_cast<float>(p[3])}};
}
inline void store(float* p, f32x4 a) {
  for (int i = 0; i < 4; ++i) p[i] = a.v[i];
}
inline f32x4 splat(float s) {
  return {{s, s, s, s}};
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
  return each_lane([&](int i) { return __builtin_sqrtf(a.v[i]); });
}
inline mask4 operator<(f32x4 a, f32x4 b) {
  return {{a.v[0] < b.v[0], a.v[1] < b.v[1], a.v[2] < b.v[2], a.v[3] < b.v[3]}};
}
inline f32x4 select(mask4 m, f32x4 yes, f32x4 no) {
  return each_lane([&](int i) { return m.v[i] ? yes.v[i] : no.v[i]; });
}
inline bool any(mask4 m) {
  return m.v[0] || m.v[1] || m.v[2] || m.v[3];
}
inline f32x4 clamp_to_unit(f32x4 a) {
  return each_lane([&](int i) { return !(0.0f < a.v[i]) ? 0.0f : a.v[i] < 1.0f ? a.v[i] : 1.0f; });
}
inline f32x4 flip(f32x4 a, f32x4 by) {
  return each_lane([&](int i) { return __builtin_signbit(by.v[i]) ? -a.v[i] : a.v[i]; });
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

inline void transpose(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
  const f32x4 rows[4] = {a, b, c, d};
  f32x4* const columns[4] = {&a, &b, &c, &d};
  for (int i = 0; i < 4; ++i) *columns[i] = each_lane([&](int j) { return rows[j].v[i]; });
}

// Twelve floats: x0 y0 z0 x1 y1 z1 …
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

}  // namespace marrow
