// Checks of goals, and matrices and vectors loaded into registers.
#pragma once

#include <cstdint>

#include "core/builtins.h"
#include "marrow/pose.h"
#include "math/affine.h"

namespace marrow {

// Whether x is in 0 … 1. Floats that are not negative are ordered as their bits are; x == 0 admits -0.
inline bool is_share(float x) {
  return bit_cast<std::uint32_t>(x) <= bit_cast<std::uint32_t>(1.0f) || x == 0;
}

inline constexpr float kMostStretch = 0x1p20f;
inline bool is_stretch(float x) {  // 1 … kMostStretch
  constexpr auto least = bit_cast<std::uint32_t>(1.0f), most = bit_cast<std::uint32_t>(kMostStretch);
  return bit_cast<std::uint32_t>(x) - least <= most - least;
}

// A target is reached where the end is nearer to it than this share of the limb's length.
inline constexpr float kNear = 1e-4f;

// Whether x is not 0 of either sign.
inline bool is_some(float x) {
  return bit_cast<std::uint32_t>(x) << 1 != 0;
}
inline bool is_some(const float (&v)[3]) {
  const auto bits = [&](int i) { return bit_cast<std::uint32_t>(v[i]); };
  return (bits(0) | bits(1) | bits(2)) << 1 != 0;
}
// Whether x is not 1.
inline bool is_partial(float x) {
  return bit_cast<std::uint32_t>(x) != bit_cast<std::uint32_t>(1.0f);
}

// A matrix by rows, a register each.
inline Linear<One> wide_rows(const Affine& a) {
  return {{load_aligned(a.rows[0])}, {load_aligned(a.rows[1])}, {load_aligned(a.rows[2])}};
}
// Three numbers. A fourth is read with them, and dropped.
inline Vector<One> wide(const float* p) {
  return {without_w(load(p))};
}
inline Vector<One> wide(const Vector3& v) {
  const float four[4] = {v.x, v.y, v.z, 0};
  return {load(four)};
}

}  // namespace marrow
