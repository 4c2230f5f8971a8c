// Legs and arms of skeletons whose names say nothing, by where their joints are.
#pragma once

#include "cook/roles/role_body.h"

namespace marrow::cook {

// Of characters that stand upright in the scene and look along z or against it. Two chains that mirror each other and
// reach the lowest joints are legs; two more, farther up from where those meet, are front legs if they too reach the
// ground, else arms are the longest such chains. Does nothing where a name says anything.
void find_by_shape(Body& body);

}  // namespace marrow::cook
