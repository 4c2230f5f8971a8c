// Fingers, by what joints are called.
#pragma once

#include "cook/roles/role_body.h"

namespace marrow::cook {

// Gives the three joints of each finger, from the palm out, where they hang below the hand, or below the lower arm of
// what has none. After limbs.
void find_fingers(Body& body);

}  // namespace marrow::cook
