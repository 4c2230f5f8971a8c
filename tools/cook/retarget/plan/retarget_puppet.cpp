#include "cook/retarget/plan/retarget_puppet.h"

#include <glm/matrix.hpp>

namespace marrow::cook {

Puppet::Puppet(std::size_t joints)
    : is_turned(joints, 0),
      wanted(joints, glm::dquat(1, 0, 0, 0)),
      turns(wanted),
      local(wanted),
      model_from_joint(joints, glm::dmat4(1.0)),
      is_put(joints, 0),
      local_place(joints, glm::dvec3(0)) {}

void Puppet::pose(const RetargetPlan& plan) {
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const RetargetJoint& joint = plan.joints[j];
    const bool is_root = joint.parent == kNone;
    const glm::dquat turn_above = is_root ? joint.turn_above : turns[to_index(joint.parent)];
    Transform below = joint.rest;
    if (is_put[j] != 0) below.translation = local_place[j];
    if (is_turned[j] != 0) {
      const glm::dquat turned = glm::normalize(glm::conjugate(turn_above) * wanted[j]);
      below.rotation = joint.is_in_mirror ? in_mirrored(turned) : turned;
    }
    local[j] = below.rotation;
    turns[j] = turn_above * (joint.is_in_mirror ? in_mirrored(below.rotation) : below.rotation);
    model_from_joint[j] = (is_root ? joint.scene_above : model_from_joint[to_index(joint.parent)]) * matrix_of(below);
  }
}

void Puppet::put(const RetargetPlan& plan, std::size_t joint, const glm::dvec3& place) {
  const RetargetJoint& of = plan.joints[joint];
  const glm::dmat4& above = of.parent == kNone ? of.scene_above : model_from_joint[to_index(of.parent)];
  local_place[joint] = glm::dvec3(glm::inverse(above) * glm::dvec4(place, 1));
  is_put[joint] = 1;
}

}  // namespace marrow::cook
