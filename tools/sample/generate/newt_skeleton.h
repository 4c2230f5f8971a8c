// The newt's joints: names, parents and where they sit at rest, all in model space (metres, +Y up, facing +Z).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

namespace marrow::sample {

// The left block and the right block list the same joints in the same order, so that `side` is a plain offset.
enum Joint : int {
  kPelvis,
  kSpine1,
  kBelly,
  kSpine2,
  kChest,
  kNeck,
  kHead,
  kTail1,
  kTail2,
  kTail3,
  kTail4,
  kTail5,
  kTail6,
  kTail7,
  kTail8,
  kForearmTwistR,
  kClavicle,
  kUpperArm,
  kForearm,
  kHand,
  kFingers,
  kThigh,
  kShin,
  kFoot,
  kToes,
  kGillTop,
  kGillMid,
  kGillLow,
  kSideEnd,
};
inline constexpr int kSideStride = kSideEnd - kClavicle;
inline constexpr int kJointCount = kSideEnd + kSideStride;
inline constexpr int kTailCount = 8;

// Side 0 is the creature's left (+X), side 1 its right (-X).
constexpr int on_side(Joint joint, int side) {
  return joint + side * kSideStride;
}
constexpr float side_sign(int side) {
  return side == 0 ? 1.0f : -1.0f;
}

struct RestJoint {
  std::string name;
  int parent = -1;  // -1: child of the armature node
  glm::vec3 head{0};
  glm::vec3 tip{0};
  glm::quat turn{1, 0, 0, 0};  // model-space orientation: +Y runs from head to tip
};

using Skeleton = std::array<RestJoint, kJointCount>;

const Skeleton& skeleton();

// From a joint's head to its tip, unit length.
glm::vec3 bone_direction(int joint);

}  // namespace marrow::sample
