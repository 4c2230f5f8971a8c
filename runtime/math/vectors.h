// Four vectors at once, as memory has them.
#pragma once

#include "math/lanes.h"

namespace marrow {

using FourVectors = Vector<f32x4>;

inline FourVectors splat(float x, float y, float z) {
  return {splat(x), splat(y), splat(z)};
}
inline FourVectors load_vectors(const float (&from)[3][4]) {
  return {load_aligned(from[0]), load_aligned(from[1]), load_aligned(from[2])};
}
inline void store_vectors(float (&to)[3][4], const FourVectors& v) {
  store(to[0], v.x);
  store(to[1], v.y);
  store(to[2], v.z);
}

}  // namespace marrow
