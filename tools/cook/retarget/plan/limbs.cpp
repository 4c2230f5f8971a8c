#include "cook/retarget/plan/limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "cook/retarget/plan/pair_rigs.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr double kSineOf60Degrees = 0.8660254037844386;
constexpr double kNearGround = 0.25, kUsualAnkle = 0.1;  // of a leg's length

using Joints = std::vector<RetargetJoint>;

// Paired joints below one another.
struct Chains {
  Chains(const Joints& all, const Take& of) : joints(all), take(of), lowest(all.size()), below(all.size()) {
    for (std::size_t j = all.size(); j-- > 0;) {
      lowest[j] = j;
      for (const std::size_t child : below[j])
        if (all[lowest[child]].place.y < all[lowest[j]].place.y) lowest[j] = lowest[child];
      if (all[j].at.is_there() && all[j].upper != kNone) below[upper(j)].push_back(j);
    }
  }
  std::size_t upper(std::size_t j) const { return to_index(joints[j].upper); }

  // From the paired joint above, in the take.
  glm::dvec3 bone(std::size_t j) const { return take.rest(joints[j].at) - take.rest(joints[upper(j)].at); }
  // Above the foot of the lowest joint below `top`.
  std::size_t ankle(std::size_t top) const {
    std::size_t at = lowest[top];
    while (at != top && upper(at) != top && lies_flat(bone(at))) at = upper(at);
    return at;
  }

  const Joints& joints;
  const Take& take;
  std::vector<std::size_t> lowest;              // paired, at or below
  std::vector<std::vector<std::size_t>> below;  // the next paired ones
};

void add_leg(const Chains& chains, const Limb& limb, bool carries, Legs& legs) {
  const std::size_t top = limb.top, ankle = limb.end;
  legs.feet.push_back({ankle, 0, legs.tops.size()});
  legs.tops.push_back(top);
  legs.limbs.push_back(limb);
  if (!carries) return;
  ++legs.carrier_count;
  for (std::size_t at = ankle; at != top; at = chains.upper(at)) {
    legs.length += glm::length(chains.joints[at].place - chains.joints[chains.upper(at)].place);
    legs.taken_length += glm::length(chains.bone(at));
  }
}

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
    add_leg(chains, limb_of(joints, leg, kNone, chains.ankle(leg)), true, out);
  }
  return out;
}

const JointSole* sole_in(const BuiltSkeleton& skeleton, int joint) {
  const auto found = std::ranges::find(skeleton.roles.soles, joint, &JointSole::joint);
  return found == skeleton.roles.soles.end() ? nullptr : &*found;
}

struct LegRoles {
  Role top, middle, foot;
};

bool is_leg(const Joints& joints, int above, int top, int foot) {
  if (top == kNone || foot == kNone || !joints[to_index(top)].at.is_there() || !joints[to_index(foot)].at.is_there())
    return false;
  int at = foot;
  while (at != kNone && at != top) at = joints[to_index(at)].upper;
  while (at != kNone && at != above) at = joints[to_index(at)].upper;
  return at == above && foot != top;
}

Legs legs_by_roles(const BuiltSkeleton& skeleton, const Chains& chains, std::size_t joint_above) {
  Legs out;
  const auto add = [&](std::initializer_list<LegRoles> sides, bool carries) {
    for (const LegRoles& side : sides)
      if (!is_leg(chains.joints, static_cast<int>(joint_above), joint_with(skeleton, side.top),
                  joint_with(skeleton, side.foot)))
        return false;
    for (const LegRoles& side : sides)
      add_leg(chains,
              limb_of(chains.joints, to_index(joint_with(skeleton, side.top)), joint_with(skeleton, side.middle),
                      to_index(joint_with(skeleton, side.foot))),
              carries, out);
    return true;
  };
  if (!add({{Role::left_upper_leg, Role::left_lower_leg, Role::left_foot},
            {Role::right_upper_leg, Role::right_lower_leg, Role::right_foot}},
           true))
    return {};
  const auto stands = [&](Role role) { return sole_in(skeleton, joint_with(skeleton, role)) != nullptr; };
  if (stands(Role::left_hand) && stands(Role::right_hand))
    add({{Role::left_upper_arm, Role::left_lower_arm, Role::left_hand},
         {Role::right_upper_arm, Role::right_lower_arm, Role::right_hand}},
        false);
  return out;
}

Legs find_legs_below(const BuiltSkeleton& skeleton, const Chains& chains, std::size_t joint_above) {
  Legs out = legs_by_roles(skeleton, chains, joint_above);
  if (out.tops.empty()) out = legs_below(chains, joint_above);
  if (!(out.length > 0) || !(out.taken_length > 0)) return {};
  for (std::size_t f = 0; f < out.feet.size(); ++f) {
    const FootJoint foot = out.feet[f];
    for (const std::size_t child : chains.below[foot.joint]) out.feet.push_back({child, foot.level + 1, foot.leg});
  }
  return out;
}

void add_nodes(const Joints& joints, const Take& take, Legs& legs) {
  const std::vector<RawNode>& nodes = take.scene().nodes;
  std::vector<int> foot_of(nodes.size(), kNone);  // an index into `legs.nodes`
  for (const FootJoint& foot : legs.feet)
    if (foot.level == 0) foot_of[to_index(joints[foot.joint].at.node)] = static_cast<int>(foot.leg);
  for (const std::size_t n : take.order()) {
    const int above = nodes[n].parent == kNone ? kNone : foot_of[to_index(nodes[n].parent)];
    if (foot_of[n] == kNone && above == kNone) continue;
    FootNode node{n, 0, 0, 0};
    if (foot_of[n] != kNone) {
      node.leg = to_index(foot_of[n]);
    } else {
      node.leg = legs.nodes[to_index(above)].leg;
      node.level = legs.nodes[to_index(above)].level + 1;
    }
    node.kind = 2 * node.level + (node.leg < legs.carrier_count ? 0 : 1);
    foot_of[n] = static_cast<int>(legs.nodes.size());
    legs.nodes.push_back(node);
    if (legs.ground.size() <= node.kind) legs.ground.resize(node.kind + 1, std::numeric_limits<double>::infinity());
    legs.ground[node.kind] = std::min(legs.ground[node.kind], take.rest(n).y);
  }
}

FootHold find_hold(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig, const Joints& joints, const Legs& legs,
                   std::size_t leg) {
  const auto at = [&](std::size_t joint) { return FootHold{joint, to_index(joints[joint].at.node), {}, {}}; };
  for (const FootJoint& foot : legs.feet)
    if (foot.leg == leg && foot.level == 1) return at(foot.joint);
  const std::size_t ankle = legs.limbs[leg].end;
  FootHold out = at(ankle);
  const auto other = std::ranges::find(rig.node_of_joint, joints[ankle].at.node);
  if (other == rig.node_of_joint.end()) return out;
  const JointSole* const own = sole_in(skeleton, static_cast<int>(ankle));
  const JointSole* const taken = sole_in(rig, static_cast<int>(other - rig.node_of_joint.begin()));
  if (own == nullptr || taken == nullptr) return out;
  for (int axis = 0; axis < 3; ++axis) {
    out.place[axis] = double{own->place[axis]};
    out.taken[axis] = double{taken->place[axis]};
  }
  return out;
}

}  // namespace

Limb limb_of(const std::vector<RetargetJoint>& joints, std::size_t top, int middle, std::size_t end) {
  Limb out{top, end, middle, {}, {}};
  std::vector<std::size_t> between;
  for (int at = joints[end].upper; at != kNone && to_index(at) != top; at = joints[to_index(at)].upper)
    between.push_back(to_index(at));
  if (middle == kNone && between.size() == 1) out.middle = static_cast<int>(between[0]);
  if (out.middle == kNone) return out;
  bool is_below = true;
  for (const std::size_t at : between) {
    if (static_cast<int>(at) == out.middle) {
      is_below = false;
    } else {
      (is_below ? out.with_middle : out.with_top).push_back(at);
    }
  }
  if (is_below) out.middle = kNone;  // it has no counterpart
  return out;
}

double length_of(const RetargetPlan& plan, const Limb& limb) {
  if (limb.middle == kNone) return glm::length(plan.joints[limb.end].place - plan.joints[limb.top].place);
  const glm::dvec3& middle = plan.joints[to_index(limb.middle)].place;
  return glm::length(middle - plan.joints[limb.top].place) + glm::length(plan.joints[limb.end].place - middle);
}

double taken_length(const RetargetPlan& plan, const Limb& limb, const Take& take) {
  const auto rest = [&](std::size_t joint) { return take.rest(plan.joints[joint].at); };
  if (limb.middle == kNone) return glm::length(rest(limb.end) - rest(limb.top));
  const glm::dvec3 middle = rest(to_index(limb.middle));
  return glm::length(middle - rest(limb.top)) + glm::length(rest(limb.end) - middle);
}

double taken_bend(const RetargetPlan& plan, const Limb& limb, const Take& take) {
  if (limb.middle == kNone) return -1;
  const auto place = [&](std::size_t joint) { return take.place(plan.joints[joint].at); };
  const glm::dvec3 middle = place(to_index(limb.middle));
  const glm::dvec3 up = place(limb.top) - middle, down = place(limb.end) - middle;
  const double lengths = glm::length(up) * glm::length(down);
  return lengths > 0 ? std::clamp(glm::dot(up, down) / lengths, -1.0, 1.0) : -1;
}

double length_at(const RetargetPlan& plan, const Limb& limb, double bend) {
  if (limb.middle == kNone) return length_of(plan, limb);
  const glm::dvec3& middle = plan.joints[to_index(limb.middle)].place;
  const double a = glm::length(middle - plan.joints[limb.top].place);
  const double b = glm::length(plan.joints[limb.end].place - middle);
  return std::sqrt(std::max(0.0, a * a + b * b - 2 * a * b * bend));
}

void reach(const Limb& limb, const glm::dvec3& place, const glm::dvec3& ahead, double most, Puppet& puppet) {
  if (limb.middle == kNone) return;
  const std::size_t middle = to_index(limb.middle);
  const glm::dvec3 top = puppet.place(limb.top);
  const glm::dvec3 upper = puppet.place(middle) - top, lower = puppet.place(limb.end) - puppet.place(middle);
  const glm::dvec3 whole = upper + lower, wanted = place - top;
  const double a = glm::length(upper), b = glm::length(lower), before = glm::length(whole);
  const double far = glm::length(wanted);
  const double length = std::clamp(std::min(far, std::max(before, most)), std::abs(a - b), a + b);
  if (!(a > 0) || !(b > 0) || !(before > 0) || !(far > 0) || !(length > 0)) return;
  const glm::dvec3 old_way = whole / before, way = wanted / far;
  glm::dvec3 bent = upper - glm::dot(upper, old_way) * old_way;
  constexpr double kStraight = 0.02;
  const double straight = kStraight * (a + b) - glm::length(bent);
  if (straight > 0) bent += straight * ahead;
  bent = arc(old_way, way) * bent;
  bent -= glm::dot(bent, way) * way;
  if (!(glm::length(bent) > 0)) return;
  const double along = (a * a - b * b + length * length) / (2 * length);
  const glm::dvec3 new_upper = along * way + std::sqrt(std::max(0.0, a * a - along * along)) * glm::normalize(bent);
  const glm::dvec3 new_lower = length * way - new_upper;
  if (!(glm::length(new_upper) > 0) || !(glm::length(new_lower) > 0)) return;
  const glm::dquat turned = arc(upper / a, glm::normalize(new_upper));
  const glm::dquat turned_below = arc(lower / b, glm::normalize(new_lower));
  puppet.turn(limb.top, turned);
  for (const std::size_t joint : limb.with_top) puppet.turn(joint, turned);
  puppet.turn(middle, turned_below);
  for (const std::size_t joint : limb.with_middle) puppet.turn(joint, turned_below);
}

bool lies_flat(const glm::dvec3& bone) {
  return std::abs(bone.y) < kSineOf60Degrees * glm::length(bone);
}

std::vector<Legs> find_legs(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig,
                            const std::vector<RetargetJoint>& joints, const std::vector<std::size_t>& joints_above,
                            const Take& take) {
  const Chains chains(joints, take);
  std::vector<Legs> out;
  for (const std::size_t joint : joints_above) {
    out.push_back(find_legs_below(skeleton, chains, joint));
    add_nodes(joints, take, out.back());
    for (std::size_t leg = 0; leg < out.back().tops.size(); ++leg)
      out.back().holds.push_back(find_hold(skeleton, rig, joints, out.back(), leg));
  }
  return out;
}

void find_ground(Legs& legs, std::vector<double> lowest) {
  const double leg = legs.mean_taken_length();
  if (legs.ground.at(0) >= 0 && legs.ground[0] <= kNearGround * leg) {
    for (std::size_t i = 0; i < lowest.size(); ++i) lowest[i] = std::min(lowest[i], legs.ground[i]);
  } else if (std::abs(lowest.at(0)) > kNearGround * leg) {
    const double above_ground = lowest[0] - kUsualAnkle * leg;
    for (double& y : lowest) y -= above_ground;
  }
  legs.ground = std::move(lowest);
}
}  // namespace marrow::cook
