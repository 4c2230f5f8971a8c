#include "deform/half_joints.h"

#include <algorithm>
#include <map>

#include "deform/rotation_of_matrix.h"
#include "deform/slerp.h"

namespace marrow::deform {

Matrix half_way(const Matrix& parent, const Matrix& joint, const glm::dvec3& centre, double share) {
  const glm::dmat3 a = rotation_of(linear_of(parent)), b = rotation_of(linear_of(joint));
  const glm::dquat turn = quaternion_of(glm::transpose(a) * b);
  const glm::dmat3 rotation = a * glm::mat3_cast(slerp(glm::dquat(1, 0, 0, 0), turn, share));
  const glm::dmat3 linear =
      rotation * (glm::transpose(a) * linear_of(parent) * (1 - share) + glm::transpose(b) * linear_of(joint) * share);
  const glm::dvec3 moved = transform(parent, centre) * (1 - share) + transform(joint, centre) * share;
  return {linear[0], linear[1], linear[2], moved - linear * centre};
}

void append_half_joints(const std::vector<HalfJoint>& half_joints, Pose& pose) {
  for (const HalfJoint& h : half_joints) pose.push_back(half_way(pose[h.parent], pose[h.joint], h.centre, h.share));
}

std::vector<HalfJoint> add_half_joints(const std::vector<int>& parents, const std::vector<glm::dvec3>& centres,
                                       int per_joint, Coordinates& candidates) {
  std::vector<HalfJoint> out;
  std::map<std::uint32_t, std::uint32_t> first_of_joint;  // its first helper
  for (std::vector<Coordinate>& vertex : candidates) {
    std::vector<Coordinate> helpers;
    for (const Coordinate& c : vertex) {
      const int parent = parents[c.joint];
      if (parent < 0) continue;
      const auto p = static_cast<std::uint32_t>(parent);
      if (std::ranges::find(vertex, p, &Coordinate::joint) == vertex.end()) continue;
      const auto [at, is_new] =
          first_of_joint.try_emplace(c.joint, static_cast<std::uint32_t>(parents.size() + out.size()));
      for (int i = 1; is_new && i <= per_joint; ++i)
        out.push_back({p, c.joint, static_cast<double>(i) / (per_joint + 1), centres[c.joint]});
      for (int i = 0; i < per_joint; ++i)
        helpers.push_back({at->second + static_cast<std::uint32_t>(i), glm::dvec4(0)});
    }
    vertex.insert(vertex.end(), helpers.begin(), helpers.end());
    std::ranges::sort(vertex, {}, &Coordinate::joint);
  }
  return out;
}

}  // namespace marrow::deform
