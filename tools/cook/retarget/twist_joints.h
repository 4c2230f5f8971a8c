// Joints that only twist along a limb, so that the skin does not wring.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/retarget_puppet.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// A joint below one of a limb's two bones.
struct TwistJoint {
  std::size_t joint = 0;
  std::size_t follows = 0;  // a joint whose twist about the axis it shares
  glm::dvec3 axis{0};       // of the bone, in its space, of length 1
  double share = 0;         // below 0: it turns the other way
};

// Joints without a counterpart that are called twist or roll, and hang on a bone of an arm or a leg by its role. On a
// lower one they turn with the hand or foot, on an upper one back from the bone's own twist; in both cases as far as
// they are along the bone.
std::vector<TwistJoint> find_twists(const BuiltSkeleton& skeleton, const RetargetPlan& plan);

// Turns them, in the puppet's local rotations alone; its next pose() undoes it.
void twist(const RetargetPlan& plan, const std::vector<TwistJoint>& joints, Puppet& puppet);

}  // namespace marrow::cook
