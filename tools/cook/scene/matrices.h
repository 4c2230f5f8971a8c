// Matrices of the scene's nodes.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "cook/scene/raw.h"
#include "marrow/pose.h"

namespace marrow::cook {

inline constexpr Affine kIdentityMap = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

// parent_from_node: translate · rotate · scale.
glm::dmat4 local_matrix(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);
glm::dmat4 local_matrix(const RawNode& node);

// The rows of an affine matrix, in single precision and without what is as good as 0, and back.
Affine to_affine(const glm::dmat4& m);
glm::dmat4 to_matrix(const Affine& a);

// The farthest that a linear map takes a point 1 from the origin: its spectral norm.
double largest_stretch(const glm::dmat3& linear);

}  // namespace marrow::cook
