#pragma once

#include <glm/gtc/quaternion.hpp>

namespace marrow::deform {

// From a to b or -b, whichever is nearer, at a constant speed: glm::slerp without the C library's functions.
glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double share);

}  // namespace marrow::deform
