// The constants of the kernels for limbs and aims, four times each. They are defined in numbers.cpp because GCC
// broadcasts known constants at run time: 3 % more instructions in a limb, 5 % in an aim.
#pragma once

#include "math/lane.h"

namespace marrow {

struct alignas(16) SplatConstant {
  float lanes[4];
};
struct Numbers {
  SplatConstant one, half, four;
  SplatConstant tiny;              // kTinySquare
  SplatConstant huge;              // squares from here on count as infinite
  SplatConstant straight;          // below this sine of the bend, the preferred bend axis is mixed in
  SplatConstant least_distance;    // from start joint to end joint, as a share of the limb's length
  SplatConstant cone_squared;      // kPoleCone, squared
  SplatConstant far;               // directions with a smaller 1 + cosine between them are far apart
  SplatConstant no_side;           // kNoSide
  SplatConstant no_angle_squared;  // directions at a smaller angle, squared, are one
  SplatConstant near;              // kNear
};
// Hidden, so that a shared library addresses them directly; on Windows it does anyway.
#ifndef _WIN32
[[gnu::visibility("hidden")]]
#endif
extern const Numbers kNumbers;

template <class F>
F number(const SplatConstant& n);
template <>
inline f32x4 number(const SplatConstant& n) {
  return load_aligned(n.lanes);
}
template <>
inline One number(const SplatConstant& n) {
  return {load_aligned(n.lanes)};
}

}  // namespace marrow
