// A character's joints in the scene, at a frame of a take.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "cook/retarget/plan/retarget_plan.h"

namespace marrow::cook {

struct Puppet {
  explicit Puppet(std::size_t joints);

  // As turns and places are wanted; joints that none is wanted of stand as at rest below their parents.
  void pose(const RetargetPlan& plan);

  glm::dvec3 place(std::size_t joint) const { return glm::dvec3(model_from_joint[joint][3]); }

  // Puts a joint at a place in the scene, from the next pose() on, and below a parent that is where it will be then.
  void put(const RetargetPlan& plan, std::size_t joint, const glm::dvec3& place);

  std::vector<char> is_turned;     // a turn is wanted
  std::vector<glm::dquat> wanted;  // rotations in the scene
  std::vector<glm::dquat> turns;   // that came out
  std::vector<glm::dquat> local;   // the same, below the parent
  std::vector<glm::dmat4> model_from_joint;
  std::vector<char> is_put;             // a place is wanted
  std::vector<glm::dvec3> local_place;  // below the parent
};

}  // namespace marrow::cook
