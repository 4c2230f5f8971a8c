// A leg or an arm of two bones that bends so that its end comes to a place.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

class Take;
struct RetargetJoint;
struct RetargetPlan;
struct Puppet;

struct Limb {
  std::size_t top = 0, end = 0;
  int middle = kNone;                              // kNone: it does not bend
  std::vector<std::size_t> with_top, with_middle;  // joints with counterparts between these and what is below
};

// `end` hangs below `top`. middle: kNone: the only joint with a counterpart that is between the two, if there is one.
Limb limb_of(const std::vector<RetargetJoint>& joints, std::size_t top, int middle, std::size_t end);

// How far the end can be from the top, in the character and in the take.
double length_of(const RetargetPlan& plan, const Limb& limb);
double taken_length(const RetargetPlan& plan, const Limb& limb, const Take& take);

// The cosine of the angle at the take's knee or elbow, -1 where it is straight; and how far the character's end is from
// the top at this angle.
double taken_bend(const RetargetPlan& plan, const Limb& limb, const Take& take);
double length_at(const RetargetPlan& plan, const Limb& limb, double bend);

// Wants the limb's joints to turn so that its end, which is posed, comes to `place`, or as near as it can. The limb
// turns by the shortest way and bends in its plane, a straight one towards `ahead`. It is stretched no farther than to
// `most`, unless it is so already. Other joints' turns stay as they are wanted. To be followed by Puppet::pose().
void reach(const Limb& limb, const glm::dvec3& place, const glm::dvec3& ahead, double most, Puppet& puppet);

}  // namespace marrow::cook
