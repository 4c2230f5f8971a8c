#include "deform/half_joints.h"

#include <algorithm>
#include <map>

#include "deform/rotation.h"

namespace marrow::deform {

Matrix half_way(const Matrix& parent, const Matrix& joint, const glm::dvec3& centre, double share) {
  const glm::dmat3 a = rotation_of(linear_of(parent)), b = rotation_of(linear_of(joint));
  const glm::dquat turn = quaternion_of(glm::transpose(a) * b);
  const glm::dmat3 rotation = a * glm::mat3_cast(glm::slerp(glm::dquat(1, 0, 0, 0), turn, share));
  const glm::dmat3 linear =
      rotation * (glm::transpose(a) * linear_of(parent) * (1 - share) + glm::transpose(b) * linear_of(joint) * share);
  const glm::dvec3 moved = transform(parent, centre) * (1 - share) + transform(joint, centre) * share;
  return {linear[0], linear[1], linear[2], moved - linear * centre};
}

void append_half_joints(const std::vector<HalfJoint>& half_joints, Pose& pose) {
  for (const HalfJoint& h : half_joints) pose.push_back(half_way(pose[h.parent], pose[h.joint], h.centre, h.share));
}

namespace {

using Weights = std::map<std::uint32_t, double>;

// The largest first.
std::vector<std::pair<double, std::uint32_t>> joints_by_weight(const Weights& weights) {
  std::vector<std::pair<double, std::uint32_t>> out;
  for (const auto& [joint, weight] : weights) out.emplace_back(-weight, joint);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

HalfJointMesh with_half_joints(const SkinnedMesh& mesh, const std::vector<int>& parents,
                               const std::vector<glm::dvec3>& centres, int per_joint,
                               const std::vector<std::size_t>& most) {
  HalfJointMesh out{mesh, {}};
  std::map<std::uint32_t, std::uint32_t> first_of_joint;  // its first helper
  for (std::size_t v = 0; v < out.mesh.influences.size(); ++v) {
    std::vector<Influence>& influences = out.mesh.influences[v];
    Weights weights;
    for (const Influence& i : influences) weights[i.joint] = i.weight;
    std::size_t count = influences.size();
    const auto own = weights;
    for (const auto& [negative, joint] : joints_by_weight(own)) {
      const int parent = parents[joint];
      if (parent < 0 || !own.contains(static_cast<std::uint32_t>(parent))) continue;
      if (count + static_cast<std::size_t>(per_joint) > most[v]) break;
      count += static_cast<std::size_t>(per_joint);
      const auto p = static_cast<std::uint32_t>(parent);
      const auto [at, is_new] = first_of_joint.try_emplace(joint, out.mesh.joint_count);
      if (is_new) {
        out.mesh.joint_count += static_cast<std::uint32_t>(per_joint);
        for (int i = 1; i <= per_joint; ++i)
          out.half_joints.push_back({p, joint, static_cast<double>(i) / (per_joint + 1), centres[joint]});
      }
      for (int i = 0; i < per_joint; ++i) weights[at->second + static_cast<std::uint32_t>(i)] += 0;
    }
    influences.clear();
    for (const auto& [joint, weight] : weights) influences.push_back({joint, weight});
  }
  return out;
}

}  // namespace marrow::deform
