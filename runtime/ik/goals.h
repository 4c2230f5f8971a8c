// Goals and matrices as the solvers of inverse kinematics read them.
#pragma once

#include <cstdint>

#include "core/builtins.h"
#include "marrow/pose.h"
#include "math/affine.h"

namespace marrow {

// Whether x is in 0 … 1: for numbers that are not negative, the order of the numbers is that of their bits.
inline bool is_share(float x) {
  return bit_cast<std::uint32_t>(x) <= bit_cast<std::uint32_t>(1.0f) || x == 0;
}

inline constexpr float kMostStretch = 0x1p20f;
inline bool is_stretch(float x) {  // 1 … kMostStretch
  constexpr auto least = bit_cast<std::uint32_t>(1.0f), most = bit_cast<std::uint32_t>(kMostStretch);
  return bit_cast<std::uint32_t>(x) - least <= most - least;
}

// Of a limb's length: what counts as reached.
inline constexpr float kNear = 1e-4f;

// Whether x is not 0, or not 1; in few instructions.
inline bool is_some(float x) {
  return bit_cast<std::uint32_t>(x) << 1 != 0;
}
inline bool is_some(const float (&v)[3]) {
  const auto bits = [&](int i) { return bit_cast<std::uint32_t>(v[i]); };
  return (bits(0) | bits(1) | bits(2)) << 1 != 0;
}
inline bool is_partial(float x) {
  return bit_cast<std::uint32_t>(x) != bit_cast<std::uint32_t>(1.0f);
}

// In one register each. Of a matrix the rows.
inline Linear<One> wide_rows(const Affine& a) {
  return {{load_aligned(a.rows[0])}, {load_aligned(a.rows[1])}, {load_aligned(a.rows[2])}};
}
// Three numbers with something behind them in memory.
inline Vector<One> wide(const float* p) {
  return {without_w(load(p))};
}
inline Vector<One> wide(const Vector3& v) {
  const float four[4] = {v.x, v.y, v.z, 0};
  return {load(four)};
}

}  // namespace marrow
