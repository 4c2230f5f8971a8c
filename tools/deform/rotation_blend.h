// Blends of joints' rotations, as quaternions.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The nearest one of each joint's matrix.
std::vector<glm::dquat> rotations_of(const Pose& pose);

const Influence& largest(const std::vector<Influence>& influences);

// The sum of the joints' quaternions by weight, each of q and -q with the sign nearer to that of the largest weight;
// `each` is called with a joint and its part of the sum.
template <class Each>
glm::dquat blend_rotations(const std::vector<Influence>& influences, const std::vector<glm::dquat>& rotations,
                           const Each& each) {
  const glm::dquat pivot = rotations[largest(influences).joint];
  glm::dquat sum(0, 0, 0, 0);
  for (const Influence& i : influences) {
    const glm::dquat& q = rotations[i.joint];
    const glm::dquat part = q * (glm::dot(pivot, q) < 0 ? -i.weight : i.weight);
    sum = sum + part;
    each(i, part);
  }
  return sum;
}

// The dual quaternion of (q, p) takes the vertex, as origin, to p and turns by q about it: its dual part is p q / 2.
// The blend's takes it to 2 d r* / |r|², of the sums r of real and d of dual parts.
glm::dvec3 by_dual_quaternion(const std::vector<Influence>& influences, const std::vector<glm::dquat>& rotations,
                              const Pose& pose, const glm::dvec3& bind);

}  // namespace marrow::deform
