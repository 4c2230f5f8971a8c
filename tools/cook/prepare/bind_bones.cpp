#include "cook/prepare/bind_bones.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cook/scene/matrices.h"

namespace marrow::cook {
namespace {

// For each node the number of the joint at or above it; kNone: none.
std::vector<int> joint_above(const RawScene& scene, const std::vector<int>& joints) {
  std::vector<int> number(scene.nodes.size(), kNone), out;
  std::vector<char> is_joint(scene.nodes.size(), 0);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    number[to_index(joints[j])] = static_cast<int>(j);
    is_joint[to_index(joints[j])] = 1;
  }
  for (const std::size_t n : nearest_known(scene, is_joint)) out.push_back(number[n]);
  return out;
}

struct JointTree {
  std::vector<int> parent;        // of a joint: the joint above
  std::vector<glm::dvec3> place;  // in the space that bones are wanted in
  std::vector<char> usable, has_bone;
};

JointTree tree_of(const RawScene& scene, const std::vector<int>& joints, const std::vector<int>& above,
                  const std::vector<glm::dmat4>& space_from_joint) {
  JointTree out;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int up = scene.nodes[to_index(joints[j])].parent;
    out.parent.push_back(up == kNone ? kNone : above[to_index(up)]);
    out.usable.push_back(is_usable(space_from_joint[j]));
    out.place.emplace_back(out.usable.back() != 0 ? glm::dvec3(space_from_joint[j][3]) : glm::dvec3(0));
  }
  out.has_bone.assign(joints.size(), 0);
  return out;
}

// Bones to children that are no joints and draw nothing: where a hand ends, say. Those further away than any bone is
// long are something else, a camera or a target.
void add_ends(const RawScene& scene, const std::vector<int>& joints, const std::vector<int>& above,
              const std::vector<glm::dmat4>& space_from_joint, double longest, JointTree& tree,
              std::vector<deform::Bone>& bones) {
  std::vector<char> draws(scene.nodes.size(), 0);
  for (const RawInstance& instance : scene.instances) draws[to_index(instance.node)] = 1;
  const std::vector<char> has_bone = tree.has_bone;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const int parent = scene.nodes[n].parent;
    if (parent == kNone || above[n] == kNone || draws[n] != 0) continue;
    const std::size_t j = to_index(above[n]);
    if (joints[j] != parent || has_bone[j] != 0 || tree.usable[j] == 0) continue;
    const glm::dvec3 end(space_from_joint[j] * glm::dvec4(scene.nodes[n].translation, 1));
    const double length = glm::length(end - tree.place[j]);
    if (!(length > 0 && length <= longest)) continue;
    bones.push_back({static_cast<std::uint32_t>(j), tree.place[j], end});
    tree.has_bone[j] = 1;
  }
}

}  // namespace

bool is_usable(const glm::dmat4& matrix) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(matrix[c][r]) <= kFarthestPlace)) return false;
  const double determinant = glm::determinant(glm::dmat3(matrix));
  return std::isfinite(1 / determinant) && std::isfinite(determinant);
}

std::vector<std::size_t> nearest_known(const RawScene& scene, std::vector<char> known) {
  std::vector<std::size_t> out(scene.nodes.size()), way;
  std::iota(out.begin(), out.end(), std::size_t{0});
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    std::size_t at = n;
    for (; known[at] == 0 && scene.nodes[at].parent != kNone; at = to_index(scene.nodes[at].parent)) way.push_back(at);
    known[at] = 1;
    for (; !way.empty(); way.pop_back()) {
      out[way.back()] = out[at];
      known[way.back()] = 1;
    }
  }
  return out;
}

std::vector<glm::dmat4> rest_of_nodes(const RawScene& scene) {
  std::vector<glm::dmat4> out(scene.nodes.size());
  std::vector<char> known(scene.nodes.size(), 0);
  std::vector<std::size_t> way;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    for (std::size_t at = n; known[at] == 0; at = to_index(scene.nodes[at].parent)) {
      way.push_back(at);
      if (scene.nodes[at].parent == kNone) break;
    }
    for (; !way.empty(); way.pop_back()) {
      const RawNode& node = scene.nodes[way.back()];
      const glm::dmat4 own = local_matrix(node);
      out[way.back()] = node.parent == kNone ? own : out[to_index(node.parent)] * own;
      known[way.back()] = 1;
    }
  }
  return out;
}

std::vector<deform::Bone> bones_of(const RawScene& scene, const std::vector<int>& joints,
                                   const std::vector<glm::dmat4>& space_from_joint) {
  const std::vector<int> above = joint_above(scene, joints);
  JointTree tree = tree_of(scene, joints, above, space_from_joint);
  std::vector<deform::Bone> bones;
  double longest = 0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int parent = tree.parent[j];
    if (parent == kNone || tree.usable[j] == 0 || tree.usable[to_index(parent)] == 0) continue;
    bones.push_back({static_cast<std::uint32_t>(parent), tree.place[to_index(parent)], tree.place[j]});
    tree.has_bone[to_index(parent)] = 1;
    longest = std::max(longest, glm::length(tree.place[j] - tree.place[to_index(parent)]));
  }
  add_ends(scene, joints, above, space_from_joint, longest, tree, bones);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (tree.has_bone[j] != 0 || tree.usable[j] == 0) continue;
    const int parent = tree.parent[j];
    const bool has_parent = parent != kNone && tree.usable[to_index(parent)] != 0;
    const glm::dvec3 from = tree.place[j], before = has_parent ? tree.place[to_index(parent)] : from;
    bones.push_back({static_cast<std::uint32_t>(j), from, from + (from - before) * 0.5});
  }
  return bones;
}

}  // namespace marrow::cook
