// A clip of a take, frame by frame, on a character's joints.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cook/retarget/feet.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "marrow/roles.h"

namespace marrow::cook {

// From and to, in seconds, ascending; of a loop a span that goes on at its start is two.
struct FootSpans {
  Role foot = Role::none;
  std::vector<std::pair<double, double>> spans_s;
};

// As find_contacts() has them, of every foot with a role. `rig`: a skeleton of the scene, with roles. None where the
// clip is too short or too long to be looked at.
std::vector<FootSpans> taken_contacts(const BuiltSkeleton& rig, const RawClip& clip);

// A joint below one of a limb's two bones.
struct TwistJoint {
  std::size_t joint = 0;
  std::size_t follows = 0;  // a joint whose twist about the axis it shares
  glm::dvec3 axis{0};       // of the bone, in its space, of length 1
  double share = 0;         // below 0: it turns the other way
};

// Joints without a counterpart that are called twist or roll, and hang on a bone of an arm or a leg by its role. On a
// lower one they turn with the hand or foot, on an upper one back from the bone's own twist; in both cases as far as
// they are along the bone.
std::vector<TwistJoint> find_twists(const BuiltSkeleton& skeleton, const RetargetPlan& plan);

// Turns them, in the puppet's local rotations alone; its next pose() undoes it.
void twist(const RetargetPlan& plan, const std::vector<TwistJoint>& joints, Puppet& puppet);

// The keys of each joint, one a frame; none: it does not move.
struct TakenKeys {
  std::vector<std::vector<glm::vec4>> turns, places;
};

// The clip that the take has taken up, on the character's skeleton. `meshes`: of that. Feet
// without `contacts` stand while they are low. Throws tools::Failure (invalid)
// where a place comes out beyond what a file may hold; `file`: of the character.
TakenKeys play_take(const BuiltSkeleton& skeleton, RetargetPlan& plan, Take& take,
                    const std::vector<FootSpans>& contacts, const std::vector<Mesh>& meshes, const std::string& file);

}  // namespace marrow::cook
