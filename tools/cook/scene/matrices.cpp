#include "cook/scene/matrices.h"

namespace marrow::cook {

glm::dmat4 local_matrix(const RawNode& node) {
  glm::dmat4 m = glm::mat4_cast(node.rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= node.scale[axis];
  m[3] = glm::dvec4(node.translation, 1.0);
  return m;
}

Affine to_affine(const glm::dmat4& m) {
  Affine a;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) a.rows[row][column] = static_cast<float>(m[column][row]);
  return a;
}

glm::dmat4 to_matrix(const Affine& a) {
  glm::dmat4 m(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) m[column][row] = static_cast<double>(a.rows[row][column]);
  return m;
}

}  // namespace marrow::cook
