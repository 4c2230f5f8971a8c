// Random numbers that are the same everywhere, and random turns.
#pragma once

#include "math/wide.h"

namespace marrow {

// PCG-XSH-RR (O'Neill 2014): the same numbers everywhere.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : state_(seed + 0x9E3779B97F4A7C15u) { bits(); }
  std::uint32_t bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + 1442695040888963407u;
    const std::uint32_t x = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27),
                        turn = static_cast<std::uint32_t>(old >> 59);
    return (x >> turn) | (x << ((32 - turn) & 31));
  }
  // A number in [0, 1), a multiple of 2⁻²⁴.
  float unit() { return static_cast<float>(bits() >> 8) * (1.0f / 16777216.0f); }
  std::size_t below(std::size_t n) { return bits() % n; }
  // A turn about any axis: of at most 120° for size 1, of more for a greater size.
  WideRotation turn(float size) {
    float v[3];
    for (float& x : v) x = unit() * 2.0f - 1.0f;
    return normalised(quaternion(to_f32x4(vector3(v)) * size, 1.0f));
  }

 private:
  std::uint64_t state_;
};

}  // namespace marrow
