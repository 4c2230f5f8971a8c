// Where the newt's joints sit at rest.
#include "newt_skeleton.h"

namespace marrow::sample {
namespace {

struct Limb {
  Joint joint;
  Joint parent;
  const char* name;
  glm::vec3 head, tip;
};

constexpr std::array<glm::vec3, kTailCount + 1> kTailPath{{{0, .475f, -.12f},
                                                           {0, .405f, -.26f},
                                                           {0, .335f, -.40f},
                                                           {0, .285f, -.55f},
                                                           {0, .265f, -.70f},
                                                           {0, .285f, -.85f},
                                                           {0, .350f, -.98f},
                                                           {0, .445f, -1.08f},
                                                           {0, .560f, -1.14f}}};

constexpr Limb kMiddle[] = {
    {kPelvis, kPelvis, "pelvis", {0, .500f, -.02f}, {0, .585f, -.01f}},
    {kSpine1, kPelvis, "spine_1", {0, .585f, -.01f}, {0, .690f, .00f}},
    {kBelly, kSpine1, "belly", {0, .600f, .10f}, {0, .600f, .22f}},
    {kSpine2, kSpine1, "spine_2", {0, .690f, .00f}, {0, .790f, .00f}},
    {kChest, kSpine2, "chest", {0, .790f, .00f}, {0, .915f, .00f}},
    {kNeck, kChest, "neck", {0, .915f, .00f}, {0, .990f, .015f}},
    {kHead, kNeck, "head", {0, .990f, .015f}, {0, 1.24f, .03f}},
};

constexpr Limb kSided[] = {
    {kClavicle, kChest, "clavicle", {.04f, .865f, .00f}, {.14f, .850f, -.005f}},
    {kUpperArm, kClavicle, "upper_arm", {.14f, .850f, -.005f}, {.300f, .720f, -.020f}},
    {kForearm, kUpperArm, "forearm", {.300f, .720f, -.020f}, {.468f, .570f, .012f}},
    {kHand, kForearm, "hand", {.468f, .570f, .012f}, {.535f, .510f, .028f}},
    {kFingers, kHand, "fingers", {.535f, .510f, .028f}, {.595f, .455f, .042f}},
    {kThigh, kPelvis, "thigh", {.115f, .470f, .00f}, {.152f, .275f, .035f}},
    {kShin, kThigh, "shin", {.152f, .275f, .035f}, {.155f, .080f, -.012f}},
    {kFoot, kShin, "foot", {.155f, .080f, -.012f}, {.170f, .030f, .095f}},
    {kToes, kFoot, "toes", {.170f, .030f, .095f}, {.178f, .026f, .185f}},
    {kGillTop, kHead, "gill_top", {.165f, 1.155f, -.050f}, {.262f, 1.345f, -.120f}},
    {kGillMid, kHead, "gill_mid", {.195f, 1.090f, -.055f}, {.385f, 1.180f, -.150f}},
    {kGillLow, kHead, "gill_low", {.180f, 1.030f, -.050f}, {.345f, .950f, -.135f}},
};

// The bone's +Y runs along it and +Z stays as near to the creature's front (for upright bones) as it can.
glm::quat look_along(glm::vec3 direction) {
  const glm::vec3 up = std::abs(direction.z) > .8f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 x = glm::normalize(glm::cross(direction, up));
  return glm::normalize(glm::quat_cast(glm::mat3(x, direction, glm::cross(x, direction))));
}

Skeleton build() {
  Skeleton all;
  for (const Limb& limb : kMiddle) {
    all[static_cast<std::size_t>(limb.joint)] = {
        limb.name, limb.joint == kPelvis ? -1 : limb.parent, limb.head, limb.tip, {}};
  }
  for (int i = 0; i < kTailCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    all[kTail1 + at] = {"tail_" + std::to_string(i + 1),
                        i == 0 ? static_cast<int>(kPelvis) : kTail1 + i - 1,
                        kTailPath[at],
                        kTailPath[at + 1],
                        {}};
  }
  for (int side = 0; side < 2; ++side) {
    const glm::vec3 mirror(side_sign(side), 1, 1);
    for (const Limb& limb : kSided) {
      const int parent = limb.parent >= kClavicle ? on_side(limb.parent, side) : static_cast<int>(limb.parent);
      all[static_cast<std::size_t>(on_side(limb.joint, side))] = {
          limb.name + std::string(side == 0 ? ".L" : ".R"), parent, mirror * limb.head, mirror * limb.tip, {}};
    }
  }
  // Only the right forearm spreads its twist over a helper joint; the left one shows what happens without.
  const RestJoint& forearm = all[static_cast<std::size_t>(on_side(kForearm, 1))];
  all[kForearmTwistR] = {
      "forearm_twist.R", on_side(kForearm, 1), glm::mix(forearm.head, forearm.tip, .5f), forearm.tip, {}};
  all[static_cast<std::size_t>(on_side(kHand, 1))].parent = kForearmTwistR;
  for (RestJoint& joint : all) joint.turn = look_along(glm::normalize(joint.tip - joint.head));
  return all;
}

}  // namespace

const Skeleton& skeleton() {
  static const Skeleton kSkeleton = build();
  return kSkeleton;
}

glm::vec3 bone_direction(int joint) {
  const RestJoint& rest = skeleton()[static_cast<std::size_t>(joint)];
  return glm::normalize(rest.tip - rest.head);
}

}  // namespace marrow::sample
