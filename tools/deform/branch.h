// A joint and all that hangs on it.
#pragma once

#include <cstdint>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Of all joints whether they turn along with one: itself and those below it. parents: of each joint its parent, or
// below 0.
std::vector<char> turned_along(std::uint32_t joint, const std::vector<int>& parents);

// The bind pose but for joints that turn along, about `centre`.
Pose turned(const std::vector<char>& turns, const glm::dvec3& centre, const glm::dmat3& turn);

}  // namespace marrow::deform
