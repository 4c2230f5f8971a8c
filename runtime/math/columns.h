// Affine maps by their columns, each in a register: quick to multiply in chains, for one joint at a time.
#pragma once

#include "core/fixed.h"
#include "math/affine.h"
#include "math/wide.h"

namespace marrow {

// Axes and origin. Lane 3 of each is 0.
struct Columns {
  f32x4 axis[3];
  f32x4 origin;
};

MARROW_CALLED_WHERE_SMALL inline f32x4 turn(const Columns& m, f32x4 v) {
  return m.axis[0] * splat_lane<0>(v) + m.axis[1] * splat_lane<1>(v) + m.axis[2] * splat_lane<2>(v);
}
MARROW_CALLED_WHERE_SMALL inline f32x4 transform(const Columns& m, f32x4 point) {
  return turn(m, point) + m.origin;
}
inline Columns operator*(const Columns& a, const Columns& b) {
  return {{turn(a, b.axis[0]), turn(a, b.axis[1]), turn(a, b.axis[2])}, transform(a, b.origin)};
}

inline Columns columns(const Affine& a) {
  f32x4 x = load_aligned(a.rows[0]), y = load_aligned(a.rows[1]), z = load_aligned(a.rows[2]), w = splat(0.0f);
  transpose(x, y, z, w);
  return {{x, y, z}, w};
}
// The axes of a rotation.
MARROW_CALLED_WHERE_SMALL inline void set_axes(WideRotation q, f32x4 (&axis)[3]) {
  float f[4];
  store(f, q.v);
  const Linear<float> m = columns_of(rotation(f));
  axis[0] = to_f32x4(m.x);
  axis[1] = to_f32x4(m.y);
  axis[2] = to_f32x4(m.z);
}

}  // namespace marrow
