// Legs and arms, by what joints are called.
#pragma once

#include "cook/roles/role_body.h"

namespace marrow::cook {

// Gives upper_leg, lower_leg, foot and toes, shoulder, upper_arm, lower_arm and hand of both sides.
void find_limbs(Body& body, const Doubt& doubt);

}  // namespace marrow::cook
