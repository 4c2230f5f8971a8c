// A joint's attitude: three axes at right angles.
#pragma once

#include "math/rotation.h"

namespace marrow {

struct RightAxes {
  Vector3 axis[3];
};

// The axes of world · scene made unit vectors at right angles, by Gram and Schmidt; a right-handed triple, mirrored or
// not.
inline RightAxes right_axes(const Affine& world, const Affine& scene) {
  const Vector3 x = normalised_or(turn(world, turn(scene, {1, 0, 0})), {1, 0, 0});
  const Vector3 y = turn(world, turn(scene, {0, 1, 0}));
  const Vector3 across = normalised_or(y - x * dot(x, y), any_across(x));
  return {{x, across, cross(x, across)}};
}

inline float determinant(const Affine& m) {
  return dot(vector3(m.rows[0]), cross(vector3(m.rows[1]), vector3(m.rows[2])));
}

// The rotation that takes the axes `from` to the axes `to`, as seen from `from` (K. Shoemake, Quaternions, 1994).
inline Rotation rotation_between(const RightAxes& from, const RightAxes& to) {
  float m[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m[r][c] = dot(from.axis[r], to.axis[c]);
  const float trace = m[0][0] + m[1][1] + m[2][2];
  if (trace > 0) return normalised(Rotation{m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], 1.0f + trace});
  int i = m[1][1] > m[0][0] ? 1 : 0;  // the largest on the diagonal
  if (m[2][2] > m[i][i]) i = 2;
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  float v[3];
  v[i] = 1.0f + m[i][i] - m[j][j] - m[k][k];
  v[j] = m[j][i] + m[i][j];
  v[k] = m[k][i] + m[i][k];
  return normalised(Rotation{v[0], v[1], v[2], m[k][j] - m[j][k]});
}

}  // namespace marrow
