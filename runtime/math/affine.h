// Products of affine maps, row by row.
#pragma once

#include "marrow/pose.h"
#include "math/f32x4.h"

namespace marrow {

// One row of a · b, from a row of `a` and the three rows of `b`.
inline f32x4 affine_row(f32x4 a, f32x4 b0, f32x4 b1, f32x4 b2) {
  const f32x4 linear = splat_lane<0>(a) * b0 + splat_lane<1>(a) * b1 + splat_lane<2>(a) * b2;
  return linear + only_w(a);  // last, so that it can be made in place
}

// out = a · b, with b given by its rows. out may be a.
inline void multiply(const Affine& a, f32x4 b0, f32x4 b1, f32x4 b2, Affine& out) {
  if constexpr (kMemoryOperands) {  // and few registers: one row at a time
    for (int row = 0; row < 3; ++row) store(out.rows[row], affine_row(load_aligned(a.rows[row]), b0, b1, b2));
  } else {  // loads and stores in pairs
    const f32x4 a0 = load_aligned(a.rows[0]), a1 = load_aligned(a.rows[1]), a2 = load_aligned(a.rows[2]);
    const f32x4 r0 = affine_row(a0, b0, b1, b2), r1 = affine_row(a1, b0, b1, b2), r2 = affine_row(a2, b0, b1, b2);
    store(out.rows[0], r0);
    store(out.rows[1], r1);
    store(out.rows[2], r2);
  }
}

// out = a · b. out is neither.
inline void multiply(const Affine& a, const Affine& b, Affine& out) {
  if constexpr (kMemoryOperands) {  // the rows of b are read where they are used, thrice
    for (int row = 0; row < 3; ++row)
      store(out.rows[row], affine_row(load_aligned(a.rows[row]), load_aligned(b.rows[0]), load_aligned(b.rows[1]),
                                      load_aligned(b.rows[2])));
  } else {
    multiply(a, load_aligned(b.rows[0]), load_aligned(b.rows[1]), load_aligned(b.rows[2]), out);
  }
}

}  // namespace marrow
