#include "cook/clip/measure/rig.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::cook {

World operator*(const World& a, const World& b) {
  return {a.linear * b.linear, a.linear * b.origin + a.origin};
}

World to_world(const Transform& t) {
  glm::dmat3 linear = glm::mat3_cast(t.rotation);
  for (int axis = 0; axis < 3; ++axis) linear[axis] *= t.scale[axis];
  return {linear, t.translation};
}

Rig::Rig(const BuiltSkeleton& skeleton) : rest(rest_transforms(skeleton)) {
  const std::size_t count = skeleton.parents.size();
  above.resize(count);
  children.resize(count);
  world.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const bool root = skeleton.parents[j] == kNoJoint;
    parents.push_back(root ? kNone : skeleton.parents[j]);
    if (root) {
      const Affine& a = skeleton.model_from_root[j];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) above[j].linear[c][r] = static_cast<double>(a.rows[r][c]);
        above[j].origin[r] = static_cast<double>(a.rows[r][3]);
      }
    }
    const glm::dmat3& linear = root ? above[j].linear : world[skeleton.parents[j]].linear;
    scale_above.push_back(std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])}));
    world[j] = place(j, root ? nullptr : &world[skeleton.parents[j]], rest[j]);
  }
  for (std::size_t j = 0; j < count; ++j)
    if (parents[j] != kNone) children[static_cast<std::size_t>(parents[j])].push_back(j);
  subtree_sizes.assign(count, 1);
  for (std::size_t j = count; j-- > 0;)
    if (parents[j] != kNone) subtree_sizes[static_cast<std::size_t>(parents[j])] += subtree_sizes[j];
}

std::vector<std::size_t> Rig::subtree(std::size_t joint) const {
  std::vector<std::size_t> out = {joint};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::vector<std::size_t>& below = children[out[i]];
    out.insert(out.end(), below.begin(), below.end());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<double> Rig::least_below(const std::vector<double>& values) const {
  std::vector<double> out = values;
  for (std::size_t j = out.size(); j-- > 0;)
    if (parents[j] != kNone) {
      double& up = out[static_cast<std::size_t>(parents[j])];
      up = std::min(up, out[j]);
    }
  return out;
}

double shell_error(const World& source, const World& other, double shell) {
  const glm::dvec3 offset = other.origin - source.origin;
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(source.linear[axis]);
    const glm::dvec3 turned =
        length > 0 ? (other.linear[axis] - source.linear[axis]) * (shell / length) : glm::dvec3(0);
    squared =
        std::max({squared, glm::dot(offset + turned, offset + turned), glm::dot(offset - turned, offset - turned)});
  }
  return std::sqrt(squared);
}

void Promise::watch(std::size_t joint, const glm::dvec4& point, const Rig& rig) {
  const double distance = glm::length(rig.world[joint].linear * glm::dvec3(point));
  if (distance <= shell) return;
  points[joint].push_back(point);
  reach[joint] = std::max(reach[joint], distance);
}

double reach_below(std::size_t joint, const Rig& rig, const Promise& promise) {
  double out = 0;
  for (const std::size_t below : rig.subtree(joint))
    out = std::max(out, glm::length(rig.world[below].origin - rig.world[joint].origin) + promise.reach[below]);
  return out;
}

}  // namespace marrow::cook
