// Rest poses in few bytes: rotations of 63 bits, and translations in whole steps of a power of two.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/builtins.h"

namespace marrow {

// Smallest three: bits 0–59 hold the numbers of x, y, z, w but for the largest, 20 bits each, in that order; 60–61
// which is the largest; 62 whether it is negative. A number n stands for (n - 2^19) · kRotationStep, so that the angle
// is within 2e-6 rad.
inline constexpr std::int32_t kRotationMiddle = 1 << 19;
inline constexpr float kRotationStep = 0.70710678f / (kRotationMiddle - 1);

inline void decode_rotation(std::uint64_t code, float (&out)[4]) {
  const auto largest = static_cast<std::uint32_t>(code >> 60 & 3);
  float squared = 0;
  for (std::uint32_t i = 0, shift = 0; i < 4; ++i) {
    if (i == largest) continue;
    const auto n = static_cast<std::int32_t>(code >> shift & 0xFFFFF) - kRotationMiddle;
    out[i] = static_cast<float>(n) * kRotationStep;
    squared += out[i] * out[i];
    shift += 20;
  }
  const float rest = 1.0f - squared;
  const float size = square_root(rest > 0 ? rest : 0);
  out[largest] = (code >> 62 & 1) != 0 ? -size : size;
}

// Translations are whole numbers of 24 bits, the sign included, times 2^exponent.
inline constexpr std::int32_t kMostTranslation = (1 << 23) - 1;

inline float decode_translation(std::int32_t number, std::int32_t exponent) {
  return std::ldexp(static_cast<float>(number), exponent);
}

}  // namespace marrow
