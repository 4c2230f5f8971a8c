#include "cook/prepare/retarget/retarget_feet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "cook/prepare/retarget/retarget_plan.h"

namespace marrow::cook {
namespace {

constexpr double kSineOf60Degrees = 0.8660254037844386;
constexpr double kNearGround = 0.25, kUsualAnkle = 0.1;  // of a leg's length

using Joints = std::vector<RetargetJoint>;
using Places = std::vector<glm::dvec3>;

// Paired joints below one another.
struct Chains {
  Chains(const Joints& all, const Places& at_rest)
      : joints(all), captured(at_rest), lowest(all.size()), below(all.size()) {
    for (std::size_t j = all.size(); j-- > 0;) {
      lowest[j] = j;
      for (const std::size_t child : below[j])
        if (all[lowest[child]].place.y < all[lowest[j]].place.y) lowest[j] = lowest[child];
      if (all[j].node != kNone && all[j].upper != kNone) below[upper(j)].push_back(j);
    }
  }
  std::size_t upper(std::size_t j) const { return to_index(joints[j].upper); }

  // From the paired joint above, in the capture.
  glm::dvec3 bone(std::size_t j) const {
    return captured[to_index(joints[j].node)] - captured[to_index(joints[upper(j)].node)];
  }
  // Above the foot of the lowest joint below `top`.
  std::size_t ankle(std::size_t top) const {
    std::size_t at = lowest[top];
    while (at != top && upper(at) != top && lies_flat(bone(at))) at = upper(at);
    return at;
  }

  const Joints& joints;
  const Places& captured;
  std::vector<std::size_t> lowest;              // paired, at or below
  std::vector<std::vector<std::size_t>> below;  // the next paired ones
};

Legs legs_below(const Chains& chains, std::size_t joint_above) {
  std::size_t top = chains.ankle(joint_above);
  while (top != joint_above && chains.below[chains.upper(top)].size() < 2) top = chains.upper(top);
  if (top == joint_above) return {};
  const Joints& joints = chains.joints;
  const std::size_t fork = chains.upper(top);
  const double half_way = (joints[fork].place.y + joints[chains.lowest[joint_above]].place.y) / 2;
  Legs out;
  for (const std::size_t leg : chains.below[fork]) {
    if (joints[chains.lowest[leg]].place.y > half_way) continue;
    out.feet.push_back({chains.ankle(leg), 0, out.tops.size()});
    out.tops.push_back(leg);
    for (std::size_t at = out.feet.back().joint; at != leg; at = chains.upper(at)) {
      out.length += glm::length(joints[at].place - joints[chains.upper(at)].place);
      out.captured_length += glm::length(chains.bone(at));
    }
  }
  for (std::size_t f = 0; f < out.feet.size(); ++f) {
    const FootJoint foot = out.feet[f];
    for (const std::size_t child : chains.below[foot.joint]) out.feet.push_back({child, foot.level + 1, foot.leg});
  }
  if (!(out.length > 0) || !(out.captured_length > 0)) return {};
  return out;
}

// Nodes come after what they hang on.
void add_nodes(const Joints& joints, const std::vector<RawNode>& nodes, const Places& captured, Legs& legs) {
  std::vector<int> foot_of(nodes.size(), kNone);  // an index into `legs.nodes`
  for (const FootJoint& foot : legs.feet)
    if (foot.level == 0) foot_of[to_index(joints[foot.joint].node)] = static_cast<int>(foot.leg);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const int above = nodes[n].parent == kNone ? kNone : foot_of[to_index(nodes[n].parent)];
    if (foot_of[n] == kNone && above == kNone) continue;
    const FootNode node = foot_of[n] != kNone
                              ? FootNode{n, 0, to_index(foot_of[n])}
                              : FootNode{n, legs.nodes[to_index(above)].level + 1, legs.nodes[to_index(above)].leg};
    foot_of[n] = static_cast<int>(legs.nodes.size());
    legs.nodes.push_back(node);
    if (legs.ground.size() <= node.level) legs.ground.push_back(captured[n].y);
    legs.ground[node.level] = std::min(legs.ground[node.level], captured[n].y);
  }
}

}  // namespace

bool lies_flat(const glm::dvec3& bone) {
  return std::abs(bone.y) < kSineOf60Degrees * glm::length(bone);
}

std::vector<Legs> find_legs(const std::vector<RetargetJoint>& joints, const std::vector<std::size_t>& joints_above,
                            const std::vector<RawNode>& nodes, const std::vector<glm::dvec3>& captured) {
  const Chains chains(joints, captured);
  std::vector<Legs> out;
  for (const std::size_t joint : joints_above) {
    out.push_back(legs_below(chains, joint));
    add_nodes(joints, nodes, captured, out.back());
  }
  return out;
}

void find_ground(Legs& legs, std::vector<double> lowest) {
  const double leg = legs.captured_length / static_cast<double>(legs.tops.size());
  if (legs.ground.at(0) >= 0 && legs.ground[0] <= kNearGround * leg) {
    for (std::size_t i = 0; i < lowest.size(); ++i) lowest[i] = std::min(lowest[i], legs.ground[i]);
  } else if (std::abs(lowest.at(0)) > kNearGround * leg) {
    const double above_ground = lowest[0] - kUsualAnkle * leg;
    for (double& y : lowest) y -= above_ground;
  }
  legs.ground = std::move(lowest);
}

}  // namespace marrow::cook
