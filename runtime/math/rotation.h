// Rotations between directions, between axes, and in maps.
#pragma once

#include "math/columns.h"
#include "math/quaternion.h"
#include "math/slerp.h"

namespace marrow {

// The shortest turn that takes the direction of `from` to that of `to`, of any lengths above 0; half a turn, about any
// axis across them, where they are opposite; the identity where either has no direction.
inline Rotation shortest_arc(const Vector3& from, const Vector3& to) {
  const Vector3 a = normalised_or(from, {}), b = normalised_or(to, {});
  const Vector3 sum = a + b;
  const float w = 0.5f * dot(sum, sum);  // 1 + cos, without cancellation
  if (w < 1e-8f) {
    if (dot(a, a) == 0) return {};
    return quaternion(any_across(a), 0.0f);
  }
  return normalised(quaternion(cross(a, b), w));
}

// The rotation in a map: its first axis keeps its direction, the second its side; scale, shear and mirroring are left
// out. Axes without a direction are made up.
inline Rotation rotation_of(const Affine& a) {
  const Vector3 x = normalised_or(column(a, 0), {1, 0, 0});
  const Rotation first = shortest_arc({1, 0, 0}, x);
  // Then about x, to the side of the second axis.
  const Vector3 from = rotate(first, {0, 1, 0}), to = normalised_or(across(column(a, 1), x), from);
  const float cosine = dot(from, to), sine = dot(x, cross(from, to));
  const bool apart = cosine > -0.9999999f;
  return normalised(quaternion(x * (apart ? sine : 1.0f), apart ? 1 + cosine : 0.0f)) * first;
}

// A joint's attitude, world · scene, as unit axes at right angles; a right-handed triple, mirrored or not.
inline Columns right_axes(const Columns& world, const Affine& scene) {
  const Columns joint = columns(scene);
  const f32x4 x = unit3_or(turn(world, joint.axis[0]), lanes(1.0f, 0.0f, 0.0f, 0.0f));
  const f32x4 y = unit3_or(across3(turn(world, joint.axis[1]), x), any_across3(x));
  return {{x, y, cross3(x, y)}, splat(0.0f)};
}

// The rotations next to four matrices' first two columns; the third column is their cross product, mirrored or not. A
// column without length stays zero.
inline Linear<f32x4> rotations_of(const Affine& a, const Affine& b, const Affine& c, const Affine& d) {
  const FourAffines m = load_affines(a, b, c, d);
  const Linear<f32x4>& r = m.rows;
  const Vector<f32x4> x = {r.x.x, r.y.x, r.z.x}, y = {r.x.y, r.y.y, r.z.y};
  return right_angles(normalised(x), y, [](const Vector<f32x4>& v) { return normalised(v); });
}

// Of a rotation matrix by columns: a component q_i of its quaternion q and 4 q_i q (Shepperd 1978). The component is w,
// or of the others the largest.
inline f32x4 scaled_quaternion(const float (&m)[3][4], bool by_w) {
  static constexpr int kNext[] = {1, 2, 0};
  float q[4];
  int i = m[1][1] > m[0][0] ? 1 : 0;
  i = m[2][2] > m[i][i] ? 2 : i;
  const int j = kNext[i], k = kNext[j];
  q[i] = 1.0f + m[i][i] - m[j][j] - m[k][k];
  q[j] = m[i][j] + m[j][i];
  q[k] = m[k][i] + m[i][k];
  q[3] = m[j][k] - m[k][j];
  if (by_w) {
    q[i] = q[3];
    q[j] = m[k][i] - m[i][k];
    q[k] = m[i][j] - m[j][i];
    q[3] = 1.0f + (m[0][0] + m[1][1] + m[2][2]);
  }
  return load(q);
}

// The rotation that takes the axes `from` to the axes `to`, as seen from `from` (K. Shoemake, Quaternions, 1994).
inline WideRotation rotation_between(const Columns& from, const Columns& to) {
  float m[3][4];
  for (int i = 0; i < 3; ++i) store(m[i], products(from.axis, to.axis[i]));
  return normalised(WideRotation{scaled_quaternion(m, m[0][0] + m[1][1] + m[2][2] > 0)});
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
