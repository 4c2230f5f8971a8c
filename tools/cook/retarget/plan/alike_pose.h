// The pose in which a character looks as a take's rig does at rest: bones of pairs point the same way.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// The shortest turn that takes one direction to another; both of length 1.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to);

// By how much each joint turns in the scene, from its rest pose to that pose: A, see retarget().
std::vector<glm::dquat> arcs_of(const BuiltSkeleton& skeleton, const std::vector<RetargetJoint>& joints,
                                const Take& take, const glm::dquat& facing);

}  // namespace marrow::cook
