// Joints that mirror each other.
#pragma once

#include <vector>

#include "cook/roles/role_body.h"

namespace marrow::cook {

// Ascending by the left joint: by roles, then by names that differ in their side alone, then by places that mirror each
// other, of joints whose parents do or are one. After all roles.
std::vector<JointPair> find_pairs(const Body& body);

// Whether the left leg is on the other side than the left arm.
bool sides_are_crossed(const Body& body);

}  // namespace marrow::cook
