#include "cook/retarget/meet_hands.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "cook/retarget/plan/pair_rigs.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr double kNear = 0.5, kFar = 1;  // of an arm's length
constexpr int kSteps = 2;                // where one arm is too short the other goes farther

std::optional<Limb> arm_of(const BuiltSkeleton& skeleton, const RetargetPlan& plan, Role top, Role middle, Role end) {
  const int joints[] = {joint_with(skeleton, top), joint_with(skeleton, middle), joint_with(skeleton, end)};
  for (const int joint : joints)
    if (joint == kNone || !plan.joints[to_index(joint)].at.is_there()) return std::nullopt;
  if (std::ranges::find(skeleton.roles.soles, joints[2], &JointSole::joint) != skeleton.roles.soles.end())
    return std::nullopt;
  const Limb out = limb_of(plan.joints, to_index(joints[0]), joints[1], to_index(joints[2]));
  return out.middle == kNone ? std::nullopt : std::optional(out);
}

}  // namespace

std::optional<Hands> find_hands(const BuiltSkeleton& skeleton, const RetargetPlan& plan, const Take& take) {
  const std::optional<Limb> left = arm_of(skeleton, plan, Role::left_upper_arm, Role::left_lower_arm, Role::left_hand);
  const std::optional<Limb> right =
      arm_of(skeleton, plan, Role::right_upper_arm, Role::right_lower_arm, Role::right_hand);
  if (!left || !right) return std::nullopt;
  const double own = length_of(plan, *left) + length_of(plan, *right);
  const double theirs = taken_length(plan, *left, take) + taken_length(plan, *right, take);
  if (!(own > 0) || !(theirs > 0)) return std::nullopt;
  return Hands{*left, *right, own / theirs};
}

void meet_hands(const RetargetPlan& plan, const Hands& hands, const Take& take, Puppet& puppet) {
  const auto place = [&](std::size_t joint) { return take.place(plan.joints[joint].at); };
  const glm::dvec3 wanted = hands.scale * (plan.facing * (place(hands.left.end) - place(hands.right.end)));
  const double arm = (length_of(plan, hands.left) + length_of(plan, hands.right)) / 2;
  const double fade = std::clamp((kFar - glm::length(wanted) / arm) / (kFar - kNear), 0.0, 1.0);
  if (!(fade > 0)) return;
  const glm::dvec3 own = puppet.place(hands.left.end) - puppet.place(hands.right.end);
  const glm::dvec3 goal = own + fade * fade * (3 - 2 * fade) * (wanted - own);
  const auto bend = [&](const Limb& limb, const glm::dvec3& by) {
    const glm::dvec3 backwards =
        puppet.turns[limb.top] * glm::conjugate(plan.joints[limb.top].aligned) * plan.facing * glm::dvec3(0, 0, -1);
    reach(limb, puppet.place(limb.end) + by, backwards, length_of(plan, limb), puppet);
  };
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 off = goal - (puppet.place(hands.left.end) - puppet.place(hands.right.end));
    bend(hands.left, 0.5 * off);
    bend(hands.right, -0.5 * off);
    puppet.pose(plan);
  }
}

}  // namespace marrow::cook
