#include "cook/prepare/retarget/retarget_puppet.h"

namespace marrow::cook {

Puppet::Puppet(std::size_t joints)
    : is_turned(joints, 0),
      wanted(joints, glm::dquat(1, 0, 0, 0)),
      turns(wanted),
      local(wanted),
      model_from_joint(joints, glm::dmat4(1.0)) {}

void Puppet::pose(const RetargetPlan& plan) {
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const RetargetJoint& joint = plan.joints[j];
    const bool is_root = joint.parent == kNone;
    const glm::dquat turn_above = is_root ? joint.turn_above : turns[to_index(joint.parent)];
    Transform below = joint.rest;
    if (is_turned[j] != 0) below.rotation = glm::normalize(glm::conjugate(turn_above) * wanted[j]);
    local[j] = below.rotation;
    turns[j] = turn_above * below.rotation;
    model_from_joint[j] = (is_root ? joint.scene_above : model_from_joint[to_index(joint.parent)]) * matrix_of(below);
  }
}

}  // namespace marrow::cook
