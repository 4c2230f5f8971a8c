// Products of affine maps, row by row.
#pragma once

#include "marrow/pose.h"
#include "math/f32x4.h"

namespace marrow {

// One row of a · b, from a row of `a` and the three rows of `b`.
inline f32x4 affine_row(f32x4 a, f32x4 b0, f32x4 b1, f32x4 b2) {
  return splat_lane<0>(a) * b0 + splat_lane<1>(a) * b1 + splat_lane<2>(a) * b2 + only_w(a);
}

// out = a · b, with b given by its rows. out may be a.
inline void multiply(const Affine& a, f32x4 b0, f32x4 b1, f32x4 b2, Affine& out) {
  for (int row = 0; row < 3; ++row) store(out.rows[row], affine_row(load_aligned(a.rows[row]), b0, b1, b2));
}

}  // namespace marrow
