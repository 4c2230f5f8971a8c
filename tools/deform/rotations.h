// Rotations: out of matrices, between two, and blended as quaternions.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The rotation next to a matrix's first two columns: Gram and Schmidt. A mirrored matrix gives the rotation that its
// first two columns agree with; one without volume gives some rotation.
glm::dmat3 rotation_of(const glm::dmat3& m);

// Whether rotation and stretch of a matrix can be told apart: it is finite and has a volume, of more than a millionth
// of that of a cube of its size.
bool has_rotation(const glm::dmat3& m);

// The rotation nearest to a matrix: R of the polar decomposition M = R S, S symmetric. Where M mirrors it is that of
// -M, so that S is -1 times a stretch. The identity where has_rotation() is false. By Newton's iteration: Higham,
// "Computing the polar decomposition", SIAM J. Sci. Stat. Comput. 7(4), 1986; within 1e-14, the same bits everywhere.
glm::dmat3 nearest_rotation(const glm::dmat3& m);

// The quaternion of a rotation, w ≥ 0.
glm::dquat quaternion_of(const glm::dmat3& rotation);

// For each joint rotation_of(M_p)ᵀ rotation_of(M_j), p its parent, which is the identity in the bind pose; also where
// there is no p, below 0.
std::vector<glm::dquat> local_rotations(const Pose& pose, const std::vector<int>& parents);

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

// From a to b or -b, whichever is nearer, at a constant speed: glm::slerp without the C library's functions.
glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double share);

}  // namespace marrow::deform
