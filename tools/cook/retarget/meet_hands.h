// Hands that are near each other in a take are so on the character.
#pragma once

#include <optional>

#include "cook/retarget/plan/limb.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/retarget_puppet.h"

namespace marrow::cook {

struct Hands {
  Limb left, right;
  double scale = 1;  // lengths of the character's arms in those of the take's
};

// By roles, where both arms have counterparts and no front legs are meant.
std::optional<Hands> find_hands(const BuiltSkeleton& skeleton, const RetargetPlan& plan, const Take& take);

// Bends the arms of a puppet that is posed so that the way from hand to hand is the take's, scaled; each hand goes half
// of it. This is so for hands that are less than half an arm apart, and fades until they are a whole one apart.
void meet_hands(const RetargetPlan& plan, const Hands& hands, const Take& take, Puppet& puppet);

}  // namespace marrow::cook
