// Unit vectors as points of an unfolded octahedron, in the numbers that Draco's bitstream uses.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/f32x4.h"

namespace marrow {

// s and t: 0 … 2^bits - 2 with (2^bits - 2) / 2 as the middle; anything else gives some unit vector, too. bits: 2 … 16.
// Source: the Draco bitstream specification, "Prediction normal decode scheme"; Cigolle et al., A Survey of Efficient
// Representations for Independent Unit Vectors (JCGT 2014). The axis is x.
inline void from_octahedron(std::int32_t s, std::int32_t t, std::uint32_t bits, float out[3]) {
  const float scale = 2.0f / static_cast<float>((1 << bits) - 2);
  float y = static_cast<float>(s) * scale - 1.0f, z = static_cast<float>(t) * scale - 1.0f;
  const float x = 1.0f - std::fabs(y) - std::fabs(z);
  const float fold = x < 0 ? -x : 0.0f;
  y += y < 0 ? fold : -fold;
  z += z < 0 ? fold : -fold;
  const float length = std::sqrt(x * x + y * y + z * z);
  out[0] = x / length;
  out[1] = y / length;
  out[2] = z / length;
}

// The same of four, in the same operations.
inline void from_octahedron(f32x4 s, f32x4 t, std::uint32_t bits, f32x4 (&out)[3]) {
  const f32x4 scale = splat(2.0f / static_cast<float>((1 << bits) - 2)), one = splat(1.0f), none = splat(0.0f);
  f32x4 y = s * scale - one, z = t * scale - one;
  const f32x4 x = one - absolute(y) - absolute(z);
  const f32x4 fold = only_where(x < none, none - x);
  y = select(y < none, y + fold, y - fold);
  z = select(z < none, z + fold, z - fold);
  const f32x4 length = sqrt(x * x + y * y + z * z);
  out[0] = x / length;
  out[1] = y / length;
  out[2] = z / length;
}

}  // namespace marrow
