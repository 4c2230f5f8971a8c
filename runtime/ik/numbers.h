// The numbers that the kernels of reaching and looking count with, four times each. They are defined elsewhere: what
// GCC knows it loads once and spreads over the lanes, which takes two instructions more.
#pragma once

#include "math/lane.h"

namespace marrow {

struct alignas(16) SplatConstant {
  float lanes[4];
};
struct Numbers {
  SplatConstant one, half, four;
  SplatConstant tiny;          // kTinySquare
  SplatConstant huge;          // of what is as good as infinite, squared; of few bits
  SplatConstant straight;      // sine of the bend below which the preferred bend axis has a say
  SplatConstant least_reach;   // of a limb's length
  SplatConstant cone_squared;  // of the sine of the angle between target and pole below which the pole loses its say
  SplatConstant far;           // 1 + cosine of the angle between directions that are far apart
  SplatConstant no_side;       // kNoSide
  SplatConstant no_angle_squared;  // of an angle between directions that are as good as one
  SplatConstant near;              // of a limb's length: what counts as reached
};
// Hidden, so that shared libraries need not look up where they are. Windows' libraries never do.
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
