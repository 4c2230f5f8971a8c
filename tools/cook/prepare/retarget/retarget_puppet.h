// A character's joints in the scene, at a frame of motion capture.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "cook/prepare/retarget/retarget_plan.h"

namespace marrow::cook {

struct Puppet {
  explicit Puppet(std::size_t joints);

  // As turns are wanted; joints that none is wanted of stand as at rest below their parents. No joint is carried.
  void pose(const RetargetPlan& plan);

  glm::dvec3 place(std::size_t joint) const { return glm::dvec3(model_from_joint[joint][3]); }

  std::vector<char> is_turned;     // a turn is wanted
  std::vector<glm::dquat> wanted;  // rotations in the scene
  std::vector<glm::dquat> turns;   // that came out
  std::vector<glm::dquat> local;   // the same, below the parent
  std::vector<glm::dmat4> model_from_joint;
};

}  // namespace marrow::cook
