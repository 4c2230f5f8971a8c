// Between Marrow's types and GLM's, for programs that use GLM.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "marrow/pose.h"

namespace marrow {

// Column-major 4×4 from three rows.
inline glm::mat4 to_glm(const Affine& a) {
  glm::mat4 m(1.0f);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) m[column][row] = a.rows[row][column];
  return m;
}

// The upper three rows; the fourth is taken to be 0 0 0 1.
inline Affine from_glm(const glm::mat4& m) {
  Affine a;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) a.rows[row][column] = m[column][row];
  return a;
}

// Stored x, y, z, w; GLM's constructor takes w first.
inline glm::quat quat_from_xyzw(const float* xyzw) {
  return glm::quat(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
}

}  // namespace marrow
