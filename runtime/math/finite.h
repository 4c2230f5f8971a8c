// Checks of arguments: not NaN, finite, within bounds.
#pragma once

#include <cstddef>

#include "core/builtins.h"
#include "math/f32x4.h"

namespace marrow {

inline bool is_number(float x) {
  return x == x;
}
inline bool is_number(double x) {
  return x == x;
}
// Neither infinite nor NaN.
inline bool is_finite(float x) {
  return x - x == 0.0f;
}
inline bool is_finite(double x) {
  return x - x == 0.0;
}
// All lanes. One check of a sum covers its terms: a sum with a term that is not finite is not finite.
inline bool all_finite(f32x4 x) {
  return all(absolute(x) < splat(kInfinity));
}
inline bool all_finite(const float* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_finite(values[i])) return false;
  }
  return true;
}

// least ≤ x ≤ most; false for what is not a number.
inline bool within(float x, float least, float most) {
  return least <= x && x <= most;
}
inline bool all_within(const float* values, std::size_t count, float least, float most) {
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) good = good && within(values[i], least, most);
  return good;
}

// Whether a vector of this squared length has a direction: it is neither too short nor too long, and not NaN.
inline bool has_direction(float squared_length) {
  return squared_length > 1e-30f && squared_length < 1e30f;
}

}  // namespace marrow
