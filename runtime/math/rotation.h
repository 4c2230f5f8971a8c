// Rotations between directions, between axes, and in maps.
#pragma once

#include "math/columns.h"
#include "math/quaternion.h"
#include "math/slerp.h"

namespace marrow {

// Right-handed orthonormal axes: x along `along`, y along the part of `aside` perpendicular to x. An axis without a
// direction is made up.
inline Columns right_axes(f32x4 along, f32x4 aside) {
  const f32x4 x = unit3_or(along, lanes(1.0f, 0.0f, 0.0f, 0.0f)), y = unit3_or(across3(aside, x), any_across3(x));
  return {{x, y, cross3(x, y)}, splat(0.0f)};
}
// The axes of a joint's orientation, world · model; right-handed even if the matrices mirror.
inline Columns right_axes(const Columns& world, const Affine& model) {
  const Columns joint = columns(model);
  return right_axes(turn(world, joint.axis[0]), turn(world, joint.axis[1]));
}

// Gram–Schmidt on the first two columns of four matrices. The third column is their cross product, even if a matrix
// mirrors. A column without length stays zero.
inline Linear<f32x4> rotations_of(const Affine& a, const Affine& b, const Affine& c, const Affine& d) {
  const FourAffines m = load_affines(a, b, c, d);
  const Linear<f32x4>& r = m.rows;
  const Vector<f32x4> x = {r.x.x, r.y.x, r.z.x}, y = {r.x.y, r.y.y, r.z.y};
  return right_angles(normalised(x), y, [](const Vector<f32x4>& v) { return normalised(v); });
}

// The rotation with these orthonormal axes (Shepperd 1978): 4 q_i q, normalised. q_i is w if the trace is above 0, else
// the largest of x, y and z.
inline WideRotation rotation_of(const f32x4 (&axis)[3]) {
  static constexpr int kNext[] = {1, 2, 0};
  float m[3][4], q[4];
  for (int c = 0; c < 3; ++c) store(m[c], axis[c]);
  int i = m[1][1] > m[0][0] ? 1 : 0;
  i = m[2][2] > m[i][i] ? 2 : i;
  const int j = kNext[i], k = kNext[j];
  q[i] = 1.0f + m[i][i] - m[j][j] - m[k][k];
  q[j] = m[i][j] + m[j][i];
  q[k] = m[k][i] + m[i][k];
  q[3] = m[j][k] - m[k][j];
  if (m[0][0] + m[1][1] + m[2][2] > 0) {
    q[i] = q[3];
    q[j] = m[k][i] - m[i][k];
    q[k] = m[i][j] - m[j][i];
    q[3] = 1.0f + (m[0][0] + m[1][1] + m[2][2]);
  }
  return normalised(WideRotation{load(q)});
}
// The rotation that takes the axes `from` to the axes `to`, in the coordinates of `from`.
inline WideRotation rotation_between(const Columns& from, const Columns& to) {
  const f32x4 seen[3] = {products(from.axis, to.axis[0]), products(from.axis, to.axis[1]),
                         products(from.axis, to.axis[2])};
  return rotation_of(seen);
}
// The rotation of a map, from its first two axes by Gram–Schmidt. Scale, shear and mirroring are left out.
inline WideRotation rotation_of(const Affine& a) {
  const Columns m = columns(a);
  return rotation_of(right_axes(m.axis[0], m.axis[1]).axis);
}

// The matrix of a quaternion of any length but 0.
template <class F>
inline Linear<F> matrix_of(const Quaternion<F>& q) {
  const F x = q.x, y = q.y, z = q.z, w = q.w, one = all_lanes<F>(1), two = all_lanes<F>(2) / dot(q, q);
  return {{one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
          {two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)},
          {two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)}};
}

}  // namespace marrow
