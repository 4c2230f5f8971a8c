// Where the ground of a take is, and how its feet lie on it.
#pragma once

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"

namespace marrow::cook {

// The rotation of a joint's counterpart since rest, as the character faces.
glm::dquat taken_turn(const RetargetPlan& plan, const RetargetJoint& joint, const Take& take);

// Finds the ground of the clip that the take has taken up. Where a foot of motion capture stands, the character's
// stands as at rest: the capture's soles may not be level at rest.
void find_stance(RetargetPlan& plan, Take& take, Legs& legs);

}  // namespace marrow::cook
