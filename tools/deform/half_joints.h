// Helpers between a joint and its parent, for what bends or twists there.
#pragma once

#include <vector>

#include "deform/animation_space.h"

namespace marrow::deform {

struct HalfJoint {
  std::uint32_t parent, joint;  // entries of the pose
  double share;                 // of the way from parent to joint, 0 … 1
  glm::dvec3 centre;            // where the joint is in the bind pose
};

// Between two matrices: the rotation on the sphere, scale and shear in proportion, about `centre`.
Matrix half_way(const Matrix& parent, const Matrix& joint, const glm::dvec3& centre, double share);

// Adds a matrix for each, in order.
void append_half_joints(const std::vector<HalfJoint>& half_joints, Pose& pose);

// Lets vertices that may follow a joint and its parent follow helpers between the two as well, `per_joint` at even
// shares: adds them to `candidates`, as zeros. Helpers are numbered from the joints' count on.
// parents, centres: of each joint.
std::vector<HalfJoint> add_half_joints(const std::vector<int>& parents, const std::vector<glm::dvec3>& centres,
                                       int per_joint, Coordinates& candidates);

}  // namespace marrow::deform
