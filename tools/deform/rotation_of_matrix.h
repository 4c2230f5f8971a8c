// Rotations out of matrices.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace marrow::deform {

// The rotation next to a matrix's first two columns: Gram and Schmidt. A mirrored matrix gives the rotation that its
// first two columns agree with; one without volume gives some rotation.
glm::dmat3 rotation_of(const glm::dmat3& m);

// The quaternion of a rotation, w ≥ 0.
glm::dquat quaternion_of(const glm::dmat3& rotation);

}  // namespace marrow::deform
