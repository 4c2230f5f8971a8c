#include "cook/retarget/twist_joints.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "cook/retarget/plan/pair_rigs.h"
#include "cook/roles/name_words.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr double kWholeTurn = 6.283185307179586;

struct Bones {
  Role upper, lower, end;
};
constexpr Bones kLimbs[] = {{Role::left_upper_arm, Role::left_lower_arm, Role::left_hand},
                            {Role::right_upper_arm, Role::right_lower_arm, Role::right_hand},
                            {Role::left_upper_leg, Role::left_lower_leg, Role::left_foot},
                            {Role::right_upper_leg, Role::right_lower_leg, Role::right_foot}};

// From `from` to `to`, in the space of `from` at rest.
glm::dvec3 way_in(const RetargetJoint& from, const glm::dvec3& to) {
  return glm::dvec3(glm::inverse(from.model_from_joint) * glm::dvec4(to, 1));
}

// The angle of a rotation about an axis, from minus half a turn to half a turn.
double twist_of(const glm::dquat& q, const glm::dvec3& axis) {
  const double angle = 2 * tools::angle_of(glm::dot(glm::dvec3(q.x, q.y, q.z), axis), q.w);
  return angle > kWholeTurn / 2 ? angle - kWholeTurn : angle < -kWholeTurn / 2 ? angle + kWholeTurn : angle;
}

}  // namespace

std::vector<TwistJoint> find_twists(const BuiltSkeleton& skeleton, const RetargetPlan& plan) {
  std::vector<TwistJoint> out;
  const auto add = [&](int bone, int end, bool is_upper) {
    if (bone == kNone || end == kNone || !plan.joints[to_index(bone)].at.is_there()) return;
    const RetargetJoint& of = plan.joints[to_index(bone)];
    if (plan.joints[to_index(end)].parent != bone || glm::determinant(of.model_from_joint) == 0) return;
    const glm::dvec3 whole = way_in(of, plan.joints[to_index(end)].place);
    const double length = glm::length(whole);
    if (!(length > 0)) return;
    for (std::size_t j = 0; j < plan.joints.size(); ++j) {
      const RetargetJoint& joint = plan.joints[j];
      if (joint.parent != bone || joint.at.is_there() || !words_of(skeleton.joint_names[j]).has(Word::twist)) continue;
      const double along = std::clamp(glm::dot(way_in(of, joint.place), whole) / (length * length), 0.0, 1.0);
      out.push_back({j, to_index(is_upper ? bone : end), whole / length, is_upper ? along - 1 : along});
    }
  };
  for (const Bones& limb : kLimbs) {
    const int lower = joint_with(skeleton, limb.lower);
    add(joint_with(skeleton, limb.upper), lower, true);
    add(lower, joint_with(skeleton, limb.end), false);
  }
  return out;
}

void twist(const RetargetPlan& plan, const std::vector<TwistJoint>& joints, Puppet& puppet) {
  for (const TwistJoint& of : joints) {
    const glm::dquat &rest = plan.joints[of.follows].rest.rotation, &now = puppet.local[of.follows];
    // In the bone's space: before an upper bone's own rotation, after a hand's.
    const glm::dquat turned = of.share < 0 ? glm::conjugate(rest) * now : now * glm::conjugate(rest);
    const double half = of.share * twist_of(turned, of.axis) / 2, sine = tools::sine(half);
    const glm::dquat by(tools::cosine(half), sine * of.axis.x, sine * of.axis.y, sine * of.axis.z);
    puppet.local[of.joint] = by * plan.joints[of.joint].rest.rotation;
    puppet.is_turned[of.joint] = 1;
  }
}

}  // namespace marrow::cook
