// Rotations of four palette entries at once, one lane an entry.
#pragma once

#include "marrow/pose.h"
#include "math/f32x4.h"

namespace marrow {

struct FourRotations {
  f32x4 m[3][3];  // row, column
};

// The rotations next to the matrices' first two columns, by Gram and Schmidt; the third column is their cross product,
// mirrored or not. A column without length stays zero.
inline FourRotations rotations_of(const Affine* const (&matrices)[4]) {
  f32x4 x[3], y[3];
  for (int row = 0; row < 3; ++row) {
    f32x4 a = load_aligned(matrices[0]->rows[row]), b = load_aligned(matrices[1]->rows[row]),
          c = load_aligned(matrices[2]->rows[row]), d = load_aligned(matrices[3]->rows[row]);
    transpose(a, b, c, d);
    x[row] = a;
    y[row] = b;
  }
  const f32x4 scale_x = inverse_length(dot3(x[0], x[1], x[2], x[0], x[1], x[2]));
  for (f32x4& v : x) v = v * scale_x;
  const f32x4 along = dot3(x[0], x[1], x[2], y[0], y[1], y[2]);
  for (int row = 0; row < 3; ++row) y[row] = y[row] - x[row] * along;
  const f32x4 scale_y = inverse_length(dot3(y[0], y[1], y[2], y[0], y[1], y[2]));
  for (f32x4& v : y) v = v * scale_y;
  return {{{x[0], y[0], x[1] * y[2] - x[2] * y[1]},
           {x[1], y[1], x[2] * y[0] - x[0] * y[2]},
           {x[2], y[2], x[0] * y[1] - x[1] * y[0]}}};
}

}  // namespace marrow
