// Rotations out of matrices.
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

}  // namespace marrow::deform
