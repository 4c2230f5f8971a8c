// What is known before the first frame of a clip is put onto a character: which joint turns as which, by how much their
// rest poses differ, and what is carried.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/retarget/plan/limbs.h"
#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"
#include "cook/scene/views.h"

namespace marrow::cook {

// A joint of the character.
struct RetargetJoint {
  int parent = kNone;                 // less than the joint's own index
  Counterpart at;                     // that it turns as
  int upper = kNone;                  // the next joint above that has a counterpart
  Transform rest;                     // below its parent
  glm::dmat4 scene_above{1.0};        // of a root: model_from_root
  glm::dquat turn_above{1, 0, 0, 0};  // its rotation
  bool is_in_mirror = false;          // the space above it is mirrored
  glm::dmat4 model_from_joint{1.0};   // to the scene, at rest
  glm::dvec3 place{0};                // in the scene at rest
  glm::dquat turn{1, 0, 0, 0};        // likewise
  glm::dquat aligned{1, 0, 0, 0};     // A · R, see retarget_clips()
};

// A joint that moves from its place. One may be above another, as a root above hips.
struct CarriedJoint {
  std::size_t joint = 0;
  double scale = 1;                   // lengths of the character in those of the take
  glm::dvec3 zero{0}, taken_zero{0};  // where the character is when the take is there
  Legs legs;
};

struct RetargetPlan {
  std::vector<RetargetJoint> joints;
  std::vector<CarriedJoint> carried;
  glm::dquat facing{1, 0, 0, 0};  // of the take to the character's scene, about y
  int facing_deg = 0;             // the same
};

// The joints of a skeleton, not aligned yet. pairs: one a joint.
std::vector<RetargetJoint> lay_out(const BuiltSkeleton& skeleton, const std::vector<Counterpart>& pairs);

// Plans the take's clip. `rig`: the take's skeleton. pairs: one a joint of the character's skeleton.
RetargetPlan plan_retarget(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig,
                           const std::vector<Counterpart>& pairs, const Take& take);

// The same without a clip. carried: which joints move from their places, ascending.
RetargetPlan plan_carrying(const std::vector<std::size_t>& carried, const BuiltSkeleton& skeleton,
                           const BuiltSkeleton& rig, const std::vector<Counterpart>& pairs, const Take& take);

// Where the character of a joint stands.
glm::dvec3 origin_of(const std::vector<RetargetJoint>& joints, std::size_t joint);

// A character's joints in the scene, at a frame of a take.
struct Puppet {
  explicit Puppet(std::size_t joints);

  // Poses all joints by their wanted turns and places. A joint without one stands as at rest below its parent.
  void pose(const RetargetPlan& plan);

  glm::dvec3 place(std::size_t joint) const { return glm::dvec3(model_from_joint[joint][3]); }

  // From the next pose() on the joint is turned by this, beside what it has turned.
  void turn(std::size_t joint, const glm::dquat& by) {
    wanted[joint] = by * turns[joint];
    is_turned[joint] = 1;
  }

  // From the next pose() on the joint is at this place in the scene. Its parent must not move in between.
  void put(const RetargetPlan& plan, std::size_t joint, const glm::dvec3& place);

  std::vector<char> is_turned;     // a turn is wanted
  std::vector<glm::dquat> wanted;  // rotations in the scene
  std::vector<glm::dquat> turns;   // that came out
  std::vector<glm::dquat> local;   // the same, below the parent
  std::vector<glm::dmat4> model_from_joint;
  std::vector<char> is_put;             // a place is wanted
  std::vector<glm::dvec3> local_place;  // below the parent
};

// The shortest turn that takes one direction to another; both of length 1.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to);

}  // namespace marrow::cook
