// Affine maps by their columns, each in a register: quick to multiply in chains, for one joint at a time.
#pragma once

#include "math/affine.h"
#include "math/wide.h"

namespace marrow {

// Axes and origin. Lane 3 of each is 0.
struct Columns {
  f32x4 axis[3];
  f32x4 origin;
};

inline f32x4 turn(const Columns& m, f32x4 v) {
  return m.axis[0] * splat_lane<0>(v) + m.axis[1] * splat_lane<1>(v) + m.axis[2] * splat_lane<2>(v);
}
inline f32x4 transform(const Columns& m, f32x4 point) {
  return turn(m, point) + m.origin;
}
// out = a · b: first b, then a. out may be b.
inline void multiply(const Columns& a, const Columns& b, Columns& out) {
  const f32x4 x = turn(a, b.axis[0]), y = turn(a, b.axis[1]), z = turn(a, b.axis[2]), origin = transform(a, b.origin);
  out = {{x, y, z}, origin};
}

inline Columns columns(const Affine& a) {
  f32x4 x = load_aligned(a.rows[0]), y = load_aligned(a.rows[1]), z = load_aligned(a.rows[2]), w = splat(0.0f);
  transpose(x, y, z, w);
  return {{x, y, z}, w};
}
// The axes of a rotation, bit for bit those of columns_of(). Each axis has one sum and one difference of products, and
// one number of the diagonal.
inline void set_axes(WideRotation q, f32x4 (&axis)[3]) {
  const f32x4 v = q.v, twice = v + v, squares = v * twice, products = v * rotated_xyz(twice);
  const f32x4 with_w = reordered<2, 0, 1, 3>(splat_lane<3>(v) * twice);
  f32x4 x = splat(1.0f) - (rotated_xyz(squares) + reordered<2, 0, 1, 3>(squares)), y = products + with_w,
        z = reordered<2, 0, 1, 3>(products - with_w), none = splat(0.0f);
  transpose(x, y, z, none);
  axis[0] = x;
  axis[1] = reordered<2, 0, 1, 3>(y);
  axis[2] = rotated_xyz(z);
}

}  // namespace marrow
