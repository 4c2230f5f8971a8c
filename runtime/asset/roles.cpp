// Roles of joints, looked up.
#include "marrow/roles.h"

#include <cstring>

namespace marrow {
namespace {

constexpr const char* kNames[] = {
    "none",
    "root",
    "hips",
    "spine",
    "chest",
    "upper_chest",
    "neck",
    "head",
    "jaw",
    "left_eye",
    "right_eye",
    "left_shoulder",
    "left_upper_arm",
    "left_lower_arm",
    "left_hand",
    "right_shoulder",
    "right_upper_arm",
    "right_lower_arm",
    "right_hand",
    "left_upper_leg",
    "left_lower_leg",
    "left_foot",
    "left_toes",
    "right_upper_leg",
    "right_lower_leg",
    "right_foot",
    "right_toes",
    "left_thumb_metacarpal",
    "left_thumb_proximal",
    "left_thumb_distal",
    "left_index_proximal",
    "left_index_intermediate",
    "left_index_distal",
    "left_middle_proximal",
    "left_middle_intermediate",
    "left_middle_distal",
    "left_ring_proximal",
    "left_ring_intermediate",
    "left_ring_distal",
    "left_little_proximal",
    "left_little_intermediate",
    "left_little_distal",
    "right_thumb_metacarpal",
    "right_thumb_proximal",
    "right_thumb_distal",
    "right_index_proximal",
    "right_index_intermediate",
    "right_index_distal",
    "right_middle_proximal",
    "right_middle_intermediate",
    "right_middle_distal",
    "right_ring_proximal",
    "right_ring_intermediate",
    "right_ring_distal",
    "right_little_proximal",
    "right_little_intermediate",
    "right_little_distal",
    "tail",
};
static_assert(sizeof kNames / sizeof *kNames == kRoleCount);
static_assert(static_cast<std::uint32_t>(Role::tail) + 1 == kRoleCount);

}  // namespace

std::uint16_t joint_of(const Roles& roles, Role role) {
  for (const JointRole& r : roles.roles)
    if (r.role == role && role != Role::none) return r.joint;
  return kNoJoint;
}

Role role_of(const Roles& roles, std::uint32_t joint) {
  for (const JointRole& r : roles.roles)
    if (r.joint == joint) return r.role;
  return Role::none;
}

std::uint16_t mirror_of(const Roles& roles, std::uint32_t joint) {
  for (const JointPair& p : roles.pairs) {
    if (p.left == joint) return p.right;
    if (p.right == joint) return p.left;
  }
  return kNoJoint;
}

const JointSole* sole_of(const Roles& roles, std::uint32_t joint) {
  for (const JointSole& s : roles.soles)
    if (s.joint == joint) return &s;
  return nullptr;
}

const char* role_name(Role role) {
  const auto number = static_cast<std::uint32_t>(role);
  return kNames[number < kRoleCount ? number : 0];
}

Role find_role(const char* name) {
  if (name == nullptr) return Role::none;
  std::uint32_t number = kRoleCount;
  while (--number > 0 && std::strcmp(kNames[number], name) != 0) {
  }
  return static_cast<Role>(number);
}

}  // namespace marrow
