// Helpers between a joint and its parent, for what bends or twists there.
#pragma once

#include <vector>

#include "deform/mesh.h"

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

// Adds influences, of weight 0, to vertices that follow a joint and its parent: of helpers between the two, `per_joint`
// at even shares. Helpers are numbered from mesh.joint_count on. Where not all fit, those of the heaviest joints do.
// parents, centres: of each joint. most: for each vertex how many influences it may have.
struct HalfJointMesh {
  SkinnedMesh mesh;
  std::vector<HalfJoint> half_joints;
};
HalfJointMesh with_half_joints(const SkinnedMesh& mesh, const std::vector<int>& parents,
                               const std::vector<glm::dvec3>& centres, int per_joint,
                               const std::vector<std::size_t>& most);

}  // namespace marrow::deform
