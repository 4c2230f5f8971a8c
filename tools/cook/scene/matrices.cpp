#include "cook/scene/matrices.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/elementary.h"
#include "cook/scene/without_tiny.h"

namespace marrow::cook {

glm::dmat4 local_matrix(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  glm::dmat4 m = glm::mat4_cast(rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
  m[3] = glm::dvec4(translation, 1.0);
  return m;
}

glm::dmat4 local_matrix(const RawNode& node) {
  return local_matrix(node.translation, node.rotation, node.scale);
}

// The largest eigenvalue of a symmetric matrix of three rows in closed form: Smith, "Eigenvalues of a symmetric 3 × 3
// matrix", Communications of the ACM 4(4), 1961.
double largest_stretch(const glm::dmat3& linear) {
  const glm::dmat3 a = glm::transpose(linear) * linear;
  const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3;
  const glm::dmat3 b = a - glm::dmat3(mean);
  double squares = 0;
  for (int c = 0; c < 3; ++c) squares += glm::dot(b[c], b[c]);
  const double p = std::sqrt(squares / 6);
  if (!(p > 0)) return std::sqrt(mean);
  const double r = std::clamp(glm::determinant(b) / (2 * p * p * p), -1.0, 1.0);
  return std::sqrt(std::max(0.0, mean + 2 * p * tools::cosine(tools::arc_cosine(r) / 3)));
}

// What is tiny beside the scale of its axis goes, too, where that is below 1.
Affine to_affine(const glm::dmat4& m) {
  Affine a;
  for (int column = 0; column < 4; ++column) {
    const glm::dvec3 axis = glm::abs(glm::dvec3(m[column]));
    const double scale = column < 3 ? std::min(1.0, std::max({axis.x, axis.y, axis.z})) : 1;
    for (int row = 0; row < 3; ++row)
      a.rows[row][column] = axis[row] < kTiny * scale ? 0.0f : static_cast<float>(m[column][row]);
  }
  return a;
}

glm::dmat4 to_matrix(const Affine& a) {
  glm::dmat4 m(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) m[column][row] = static_cast<double>(a.rows[row][column]);
  return m;
}

}  // namespace marrow::cook
