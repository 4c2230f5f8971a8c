// A clip of a take, frame by frame, on a character's joints.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"
#include "cook/retarget/planted_feet.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "marrow/roles.h"

namespace marrow::cook {

// When a foot stands: from and to in seconds, ascending. A span that goes round the end of a loop is two.
struct FootSpans {
  Role foot = Role::none;
  std::vector<std::pair<double, double>> spans_s;
};

// The contacts that find_contacts() finds in a clip of the rig, for each foot with a role. `rig`: a skeleton of the
// scene, with roles. Empty where the clip is too short or too long to be traced.
std::vector<FootSpans> taken_contacts(const BuiltSkeleton& rig, const RawClip& clip);

// A joint that only twists along one of a limb's two bones, so that the skin does not wring.
struct TwistJoint {
  std::size_t joint = 0;
  std::size_t follows = 0;  // a joint whose twist about the axis it shares
  glm::dvec3 axis{0};       // of the bone, in its space, of length 1
  double share = 0;         // below 0: it turns the other way
};

// Finds joints without a counterpart whose names say twist or roll, and that hang on a bone of an arm or a leg. On a
// lower bone they turn with the hand or foot; on an upper one they turn back from the bone's own twist. Both turn the
// more the farther along the bone they are.
std::vector<TwistJoint> find_twists(const BuiltSkeleton& skeleton, const RetargetPlan& plan);

// Turns these joints. This changes the puppet's local rotations alone, and its next pose() undoes it.
void twist(const RetargetPlan& plan, const std::vector<TwistJoint>& joints, Puppet& puppet);

// The keys of each joint, one a frame. A joint without keys does not move.
struct TakenKeys {
  std::vector<std::vector<glm::vec4>> turns, places;
};

// Puts the clip that the take has open onto the character's skeleton. `meshes`: of that skeleton. Feet without
// `contacts` stand while they are low. Throws tools::Failure (invalid), with the character's `file`, where a place
// comes out beyond what a file may hold.
TakenKeys play_take(const BuiltSkeleton& skeleton, RetargetPlan& plan, Take& take,
                    const std::vector<FootSpans>& contacts, const std::vector<Mesh>& meshes, const std::string& file);

}  // namespace marrow::cook
