// Legs and arms of a character and of a take, so that feet stand on the ground in both and ends reach a place.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct RetargetJoint;
struct RetargetPlan;
struct Puppet;

// A leg or an arm of two bones.
struct Limb {
  std::size_t top = 0, end = 0;
  int middle = kNone;                              // kNone: it does not bend
  std::vector<std::size_t> with_top, with_middle;  // joints with counterparts between these and what is below
};

// `end` must hang below `top`. With kNone as `middle`, the limb bends at the one joint with a counterpart between the
// two, if there is just one.
Limb limb_of(const std::vector<RetargetJoint>& joints, std::size_t top, int middle, std::size_t end);

// The length of the stretched limb, of the character and of the take.
double length_of(const RetargetPlan& plan, const Limb& limb);
double taken_length(const RetargetPlan& plan, const Limb& limb, const Take& take);

// taken_bend(): the cosine of the angle at the take's knee or elbow, -1 where it is straight. length_at(): how far the
// character's end is from the top at that angle.
double taken_bend(const RetargetPlan& plan, const Limb& limb, const Take& take);
double length_at(const RetargetPlan& plan, const Limb& limb, double bend);

// Sets the wanted turns of the limb's joints so that its end comes to `place`, or as near as it can; call
// Puppet::pose() after it. The puppet must be posed. The limb turns by the shortest way and bends in its plane; a
// straight one bends towards `ahead`. It is stretched to at most `most`, unless it is longer already.
void reach(const Limb& limb, const glm::dvec3& place, const glm::dvec3& ahead, double most, Puppet& puppet);

// A joint of a foot that is paired: the ankle, or one below it.
struct FootJoint {
  std::size_t joint = 0;
  std::size_t level = 0;  // 0: the ankle
  std::size_t leg = 0;    // of Legs::tops
};

// An ankle of the take, or a node below it, paired or not.
struct FootNode {
  std::size_t node = 0, level = 0, leg = 0;
  std::size_t kind = 0;  // of Legs::ground
};

// What stays in place while a foot stands: the ball; where not both rigs have one, the middle of the sole; else the
// ankle.
struct FootHold {
  std::size_t joint = 0, node = 0;  // of the character, and of the take
  glm::dvec3 place{0}, taken{0};    // in their spaces
};

struct Legs {
  std::vector<std::size_t> tops;  // joints; none: there are no legs, and no feet
  std::vector<Limb> limbs;        // a top
  std::vector<FootHold> holds;    // a top
  std::size_t carrier_count = 0;  // tops that carry the hips: all but front legs, which come last
  std::vector<FootJoint> feet;
  std::vector<FootNode> nodes;
  double length = 0, taken_length = 0;  // of all that carry, from the tops to the ankles
  // By kind: how high the take's nodes are at rest; after find_ground(), how high they are when their feet stand. The
  // kind is twice the level, and one more for front legs.
  std::vector<double> ground;

  std::vector<std::size_t> carriers() const {
    return {tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(carrier_count)};
  }
  double mean_length() const { return length / static_cast<double>(carrier_count); }
  double mean_taken_length() const { return taken_length / static_cast<double>(carrier_count); }
};

// Whether a captured bone slopes by less than 60 degrees. Bones of feet do, those of legs do not.
bool lies_flat(const glm::dvec3& bone);

// Finds the legs below each of `joints_above`. `rig`: the take's skeleton. Where both legs have roles, these say where
// they are, front legs that stand included. Else legs are the chains of paired joints that part at one joint and come
// down more than half way from it to the lowest joint.
std::vector<Legs> find_legs(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig,
                            const std::vector<RetargetJoint>& joints, const std::vector<std::size_t>& joints_above,
                            const Take& take);

// Sets `legs.ground`. `lowest`: by kind, the lowest y of the clip. Where feet rest just above y = 0, the ground is
// there, or lower where they come lower. Else it is where feet are lowest, if that is within a quarter of a leg's
// length of y = 0. Else the clip does not touch the ground, and an ankle is taken to stand a tenth of the leg's length
// high.
void find_ground(Legs& legs, std::vector<double> lowest);

}  // namespace marrow::cook
