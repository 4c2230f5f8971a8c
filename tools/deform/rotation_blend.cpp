#include "deform/rotation_blend.h"

#include <algorithm>

#include "deform/rotation_of_matrix.h"

namespace marrow::deform {

std::vector<glm::dquat> rotations_of(const Pose& pose) {
  std::vector<glm::dquat> out;
  for (const Matrix& m : pose) out.push_back(quaternion_of(nearest_rotation(linear_of(m))));
  return out;
}

const Influence& largest(const std::vector<Influence>& influences) {
  return *std::max_element(influences.begin(), influences.end(),
                           [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
}

glm::dvec3 by_dual_quaternion(const std::vector<Influence>& influences, const std::vector<glm::dquat>& rotations,
                              const Pose& pose, const glm::dvec3& bind) {
  if (influences.size() == 1) return transform(pose[influences[0].joint], bind);
  glm::dquat twice_dual(0, 0, 0, 0);
  const glm::dquat real = blend_rotations(influences, rotations, [&](const Influence& i, const glm::dquat& part) {
    const glm::dvec3 place = transform(pose[i.joint], bind);
    twice_dual = twice_dual + glm::dquat(0, place.x, place.y, place.z) * part;
  });
  const glm::dquat moved = twice_dual * glm::conjugate(real);
  return glm::dvec3(moved.x, moved.y, moved.z) / glm::dot(real, real);
}

}  // namespace marrow::deform
