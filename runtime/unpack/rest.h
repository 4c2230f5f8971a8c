// Numbers that packed files say in few bytes: rotations and scales of rest poses, and centres of helpers.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/builtins.h"

namespace marrow {

// Two bits that say how a component of a rotation is stored. kCodeLeft and kCodeMinusLeft: plus or minus what makes the
// length 1, beside the components that are given.
enum RotationCode : std::uint32_t { kCodeZero = 0, kCodeGiven = 1, kCodeLeft = 2, kCodeMinusLeft = 3 };

// squared: the given components' squares, added up in their order.
inline float left_of_rotation(double squared) {
  const double left = 1 - squared;
  return static_cast<float>(square_root(left > 0 ? left : 0.0));
}

// How a scale is stored. Exporters write numbers that differ from 1 in the last bits alone; kCodeNearOne stores those.
enum ScaleCode : std::uint32_t { kCodeOne = 0, kCodeScale = 1, kCodeNearOne = 2 };

inline float near_one(std::int8_t last_bits) {
  return bit_cast<float>(0x3F800000u + static_cast<std::uint32_t>(std::int32_t{last_bits}));
}

// Centres are whole numbers times 2^exponent.
inline float decode_centre(std::int32_t number, std::int32_t exponent) {
  return std::ldexp(static_cast<float>(number), exponent);
}

}  // namespace marrow
