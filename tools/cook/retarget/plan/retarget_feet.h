// Where the legs and feet of a character and of a take are, so that feet stand on the ground in both.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/retarget/plan/limb.h"
#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct RetargetJoint;

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

// What stays in place while a foot stands: the ball, or where there is none in both rigs the middle of the sole, or the
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
  // How high the take's nodes are at rest, and after find_ground() on the ground: a kind, which is twice the level, and
  // one more for front legs.
  std::vector<double> ground;

  std::vector<std::size_t> carriers() const {
    return {tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(carrier_count)};
  }
  double mean_length() const { return length / static_cast<double>(carrier_count); }
  double mean_taken_length() const { return taken_length / static_cast<double>(carrier_count); }
};

// Whether a captured bone slopes by less than 60 degrees, as those of feet do and those of legs do not.
bool lies_flat(const glm::dvec3& bone);

// What is below each of `joints_above`; `rig`: the take's skeleton. By roles, where both legs have some: from the upper
// leg to the foot, and front legs that stand. Else chains of paired joints that part at one joint and come down more
// than half way from it to the lowest of all.
std::vector<Legs> find_legs(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig,
                            const std::vector<RetargetJoint>& joints, const std::vector<std::size_t>& joints_above,
                            const Take& take);

// `lowest`: a kind, the lowest y of the clip. Where feet rest just above y = 0, the ground is there, or where they
// come lower. Else it is where they are lowest, if that is within a quarter of a leg's length of y = 0. Else the clip
// does not touch it, and an ankle stands as high as a tenth of the leg is long.
void find_ground(Legs& legs, std::vector<double> lowest);

}  // namespace marrow::cook
