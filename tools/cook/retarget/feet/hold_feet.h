// Feet that stay where they stand.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/retarget_puppet.h"
#include "cook/retarget/plan/take.h"

namespace marrow::cook {

// The middle of the tops of the legs that carry.
struct Middle {
  glm::dvec3 own{0}, taken{0};
};
Middle middle_of(const RetargetPlan& plan, const Legs& legs, const Take& take, const Puppet& puppet);

// Where an ankle is to go for its foot to be off its counterpart's place by `offset`; see offset_of(). Of the puppet as
// it is posed, before it is carried.
glm::dvec3 ankle_at(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const glm::dvec3& offset,
                    const Take& take, const Puppet& puppet);

// By how much what stays in place (FootHold) is off its counterpart's place when the leg points as that does: both from
// the middle of the legs' tops, the take's scaled. It changes as wider hips turn and longer feet roll.
glm::dvec3 offset_of(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const Take& take,
                     const Puppet& puppet);

// Whether the foot's counterpart touches the ground.
bool touches(const CarriedJoint& carried, std::size_t leg, const Take& take);

// A foot in a frame.
struct FootFrame {
  glm::dvec3 offset{0};
  bool touches = false;
};

// Of one leg, frame by frame: while the counterpart touches the ground the offset is the mean of all that time, so that
// the foot slides no more than its counterpart. In between it goes over from one mean to the next. A foot that touches
// the ground in the first and the last frame of a clip that begins as it ends does not let go between them.
std::vector<glm::dvec3> held(const std::vector<FootFrame>& frames, double leg_length);

}  // namespace marrow::cook
