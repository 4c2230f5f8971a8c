// Exporters leave numbers such as 1e-20 where they mean 0. Their products are denormal, and processors take many times
// as long over those.
#pragma once

#include <cmath>

namespace marrow::cook {

inline constexpr double kTiny = 1e-15;  // what is less of a pose is none; the square of what is more is at least 1e-30

// Of a translation or a rotation, not of a scale. -0 becomes +0, too: packed files have no bytes for it.
inline float without_tiny(double x) {
  return std::fabs(x) < kTiny ? 0.0f : static_cast<float>(x);
}

}  // namespace marrow::cook
