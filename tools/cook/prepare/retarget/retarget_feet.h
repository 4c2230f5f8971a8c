// Where the legs and feet of a character and of motion capture are, so that feet stand on the ground in both.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

struct RetargetJoint;

// A joint of a foot that is paired: the ankle, or one below it.
struct FootJoint {
  std::size_t joint = 0;
  std::size_t level = 0;  // 0: the ankle
  std::size_t leg = 0;    // of Legs::tops
};

// A captured ankle, or a node below it, paired or not.
struct FootNode {
  std::size_t node = 0, level = 0, leg = 0;
};

struct Legs {
  std::vector<std::size_t> tops;  // joints; none: there are no legs, and no feet
  std::vector<FootJoint> feet;
  std::vector<FootNode> nodes;
  double length = 0, captured_length = 0;  // of all legs, from the tops to the ankles
  std::vector<double>
      ground;  // a level: how high the capture's nodes are at rest, and after find_ground() on the ground
};

// Whether a captured bone slopes by less than 60 degrees, as those of feet do and those of legs do not.
bool lies_flat(const glm::dvec3& bone);

// What is below each of `joints_above`: chains of paired joints that part at one joint and come down more than half
// way from it to the lowest of all. `captured`: where the capture's nodes are at rest.
std::vector<Legs> find_legs(const std::vector<RetargetJoint>& joints, const std::vector<std::size_t>& joints_above,
                            const std::vector<RawNode>& nodes, const std::vector<glm::dvec3>& captured);

// `lowest`: a level, the lowest y of the clip. Where feet rest just above y = 0, the ground is there, or where they
// come lower. Else it is where they are lowest, if that is within a quarter of a leg's length of y = 0. Else the clip
// does not touch it, and an ankle stands as high as a tenth of the leg is long.
void find_ground(Legs& legs, std::vector<double> lowest);

}  // namespace marrow::cook
