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

// Splits the influences of vertices that follow a joint and its parent: weights w and v of the two are spread over the
// chain parent, helpers, joint as if each vertex stood on it at w / (w + v). `first` is the first helper's number.
// centres: a helper for each pair of joints in `parents` that some vertex shares. most: influences a vertex.
struct HalfJointMesh {
  SkinnedMesh mesh;
  std::vector<HalfJoint> half_joints;
};
HalfJointMesh with_half_joints(const SkinnedMesh& mesh, const std::vector<int>& parents,
                               const std::vector<glm::dvec3>& centres, int per_joint, std::size_t most);

}  // namespace marrow::deform
