// Affine maps, three rows of four: of one joint, of four at once, and by columns.
#pragma once

#include "marrow/pose.h"
#include "math/linear.h"

namespace marrow {

inline constexpr Affine kIdentity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

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

// out = a · b. out must be neither a nor b.
inline void multiply(const Affine& a, const Affine& b, Affine& out) {
  if constexpr (kMemoryOperands) {  // the rows of b are read where they are used, thrice
    for (int row = 0; row < 3; ++row)
      store(out.rows[row], affine_row(load_aligned(a.rows[row]), load_aligned(b.rows[0]), load_aligned(b.rows[1]),
                                      load_aligned(b.rows[2])));
  } else {
    multiply(a, load_aligned(b.rows[0]), load_aligned(b.rows[1]), load_aligned(b.rows[2]), out);
  }
}

inline Vector3 column(const Affine& a, int c) {
  return {a.rows[0][c], a.rows[1][c], a.rows[2][c]};
}
inline Vector3 origin(const Affine& a) {
  return column(a, 3);
}
// The same in one register.
inline Vector<One> wide_origin(const Affine& a) {
  return {fourths(load_aligned(a.rows[0]), load_aligned(a.rows[1]), load_aligned(a.rows[2]))};
}
inline Linear<float> linear(const Affine& a) {
  return {column(a, 0), column(a, 1), column(a, 2)};
}
// The transpose of its linear part: the rows.
inline Linear<float> linear_rows(const Affine& a) {
  return {vector3(a.rows[0]), vector3(a.rows[1]), vector3(a.rows[2])};
}
inline float determinant(const Affine& a) {
  return determinant(linear_rows(a));
}
inline Affine affine(const Linear<float>& m, const Vector3& origin) {
  return {{{m.x.x, m.y.x, m.z.x, origin.x}, {m.x.y, m.y.y, m.z.y, origin.y}, {m.x.z, m.y.z, m.z.z, origin.z}}};
}

// A direction through the linear part.
inline Vector3 turn(const Affine& a, const Vector3& v) {
  return transposed_times(linear_rows(a), v);
}
inline Vector3 transform(const Affine& a, const Vector3& point) {
  return turn(a, point) + origin(a);
}

// One row of each of four maps, one map per lane.
struct FourRows {
  Vector<f32x4> linear;
  f32x4 origin;
};
inline FourRows load_rows(const float* a, const float* b, const float* c, const float* d) {
  FourRows out;
  load_transposed(a, b, c, d, out.linear.x, out.linear.y, out.linear.z, out.origin);
  return out;
}
// The same in all lanes.
inline FourRows splat_row(f32x4 row) {
  return {{splat_lane<0>(row), splat_lane<1>(row), splat_lane<2>(row)}, splat_lane<3>(row)};
}

// Four maps, by rows.
struct FourAffines {
  Linear<f32x4> rows;
  Vector<f32x4> origin;
};
inline FourAffines four_affines(const FourRows& a, const FourRows& b, const FourRows& c) {
  return {{a.linear, b.linear, c.linear}, {a.origin, b.origin, c.origin}};
}
inline FourAffines load_affines(const Affine& a, const Affine& b, const Affine& c, const Affine& d) {
  return four_affines(load_rows(a.rows[0], b.rows[0], c.rows[0], d.rows[0]),
                      load_rows(a.rows[1], b.rows[1], c.rows[1], d.rows[1]),
                      load_rows(a.rows[2], b.rows[2], c.rows[2], d.rows[2]));
}
inline const Vector<f32x4>& origin(const FourAffines& m) {
  return m.origin;
}
inline const Linear<f32x4>& linear_rows(const FourAffines& m) {
  return m.rows;
}
inline f32x4 determinant(const FourAffines& m) {
  return determinant(linear_rows(m));
}
inline Vector<f32x4> turn(const FourAffines& m, const Vector<f32x4>& v) {
  return transposed_times(linear_rows(m), v);
}
inline Vector<f32x4> transform(const FourAffines& m, const Vector<f32x4>& point) {
  return turn(m, point) + origin(m);
}

}  // namespace marrow
