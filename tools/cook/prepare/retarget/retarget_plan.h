// What is known before the first frame of motion capture is put onto a character: which joint turns as which, by how
// much their rest poses differ, and what is carried.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/prepare/retarget/retarget_feet.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "cook/scene/views.h"

namespace marrow::cook {

// A joint of the character.
struct RetargetJoint {
  int parent = kNone;                 // less than the joint's own index
  int node = kNone;                   // of the capture, that it turns as; kNone: it keeps its rest pose
  int upper = kNone;                  // the next joint above that has a node
  Transform rest;                     // below its parent
  glm::dmat4 scene_above{1.0};        // of a root: model_from_root
  glm::dquat turn_above{1, 0, 0, 0};  // its rotation
  glm::dvec3 place{0};                // in the scene at rest
  glm::dquat turn{1, 0, 0, 0};        // likewise
  glm::dquat aligned{1, 0, 0, 0};     // A · R, see retarget()
};

// A joint that moves from its place; none is below another.
struct CarriedJoint {
  std::size_t joint = 0;
  double scale = 1;  // lengths of the character in those of the capture
  Legs legs;
};

struct RetargetPlan {
  std::vector<RetargetJoint> joints;
  std::vector<CarriedJoint> carried;
  glm::dquat facing{1, 0, 0, 0};  // of the capture to the character's scene, about y
  int facing_deg = 0;             // the same
};

// The shortest turn that takes one direction to another; both of length 1.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to);

// node_of_joint: as RetargetJoint::node, one a joint of the skeleton.
RetargetPlan plan_retarget(const BuiltSkeleton& skeleton, const std::vector<int>& node_of_joint,
                           const RawScene& capture);

}  // namespace marrow::cook
