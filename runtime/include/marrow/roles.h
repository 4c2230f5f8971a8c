// Which joint is the left foot, the head, the tail: roles of joints, mirrored pairs and soles, as the cooker found
// them.
#pragma once

#include "marrow/api.h"
#include "marrow/skeleton.h"
#include "marrow/span.h"

namespace marrow {

// What a joint is for. Names are those of VRM's humanoid; left and right are the character's own. Hind legs of animals
// are legs; front legs have the arms' roles, so what stands on the ground may be feet and hands. A limb's role is that
// of the joint where the limb begins: left_lower_arm is the elbow, left_hand the wrist.
enum class Role : std::uint8_t {
  none,  // of joints without a role
  root,  // above the hips: what moves all of the character
  hips,  // carries the legs and the trunk
  spine,
  chest,
  upper_chest,
  neck,
  head,
  jaw,
  left_eye,
  right_eye,
  left_shoulder,
  left_upper_arm,
  left_lower_arm,
  left_hand,
  right_shoulder,
  right_upper_arm,
  right_lower_arm,
  right_hand,
  left_upper_leg,
  left_lower_leg,
  left_foot,
  left_toes,
  right_upper_leg,
  right_lower_leg,
  right_foot,
  right_toes,
  left_thumb_metacarpal,
  left_thumb_proximal,
  left_thumb_distal,
  left_index_proximal,
  left_index_intermediate,
  left_index_distal,
  left_middle_proximal,
  left_middle_intermediate,
  left_middle_distal,
  left_ring_proximal,
  left_ring_intermediate,
  left_ring_distal,
  left_little_proximal,
  left_little_intermediate,
  left_little_distal,
  right_thumb_metacarpal,
  right_thumb_proximal,
  right_thumb_distal,
  right_index_proximal,
  right_index_intermediate,
  right_index_distal,
  right_middle_proximal,
  right_middle_intermediate,
  right_middle_distal,
  right_ring_proximal,
  right_ring_intermediate,
  right_ring_distal,
  right_little_proximal,
  right_little_intermediate,
  right_little_distal,
  tail,  // each joint of the tail has this one
};
inline constexpr std::uint32_t kRoleCount = 58;  // with none

// A joint with a role.
struct JointRole {
  std::uint16_t joint = 0;  // of the skeleton
  Role role = Role::none;   // what the joint is for
  std::uint8_t reserved = 0;
};
static_assert(sizeof(JointRole) == 4);

// Two joints that mirror each other at rest.
struct JointPair {
  std::uint16_t left = 0, right = 0;  // of the skeleton
};
static_assert(sizeof(JointPair) == 4);

// Where a foot stands.
struct JointSole {
  std::uint16_t joint = 0;  // a foot, or a hand that is a front foot
  std::uint16_t reserved = 0;
  float place[3] = {0, 0, 0};  // on the ground below the ball of the foot at rest; joint's space. As Foot::sole
};
static_assert(sizeof(JointSole) == 16);

// What is known of a skeleton's joints; see File::roles. All three are empty where nothing is.
struct Roles {
  Span<const JointRole> roles = {};  // ascending by joint; no role but tail twice
  Span<const JointPair> pairs = {};  // ascending by the left joint; a joint is in one pair at most
  Span<const JointSole> soles = {};  // ascending by joint
};

// The joint with this role; of a tail its first. kNoJoint if there is none, and for Role::none. Cost: a look at the
// roles; once a load, not a frame. This and those below are thread-safe.
MARROW_API std::uint16_t joint_of(const Roles& roles, Role role);

// The joint's role; Role::none if it has none. Cost: as joint_of().
MARROW_API Role role_of(const Roles& roles, std::uint32_t joint);

// The joint on the other side; kNoJoint if there is none, as of the spine. Cost: a look at the pairs.
MARROW_API std::uint16_t mirror_of(const Roles& roles, std::uint32_t joint);

// Where the joint stands on the ground; null if that is not known. Points into `roles`. Cost: a look at the soles.
MARROW_API const JointSole* sole_of(const Roles& roles, std::uint32_t joint);

// "left_upper_leg"; of what is no role "none". Zero-terminated, never null.
MARROW_API const char* role_name(Role role);

// The role with this name; Role::none if there is none, and for a null pointer. Cost: a look at all names.
MARROW_API Role find_role(const char* name);

}  // namespace marrow
