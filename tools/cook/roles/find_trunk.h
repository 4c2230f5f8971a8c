// What stands in the middle: hips, spine, chest, neck, head, what is on it, root and tail.
#pragma once

#include "cook/roles/role_body.h"

namespace marrow::cook {

// Hips are where the legs meet each other and the trunk; the trunk goes from there to where the arms meet, the neck on
// to the head. Names decide where they agree with that. After limbs.
void find_trunk(Body& body, const Doubt& doubt);

}  // namespace marrow::cook
