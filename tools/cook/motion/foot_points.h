// What of a foot may touch the ground.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/scene/built.h"
#include "marrow/roles.h"

namespace marrow::cook {

// A point that follows one joint; in that joint's space.
struct FootPoint {
  std::uint16_t joint = 0;
  glm::dvec3 place{0};
};

// A foot, or a hand that is a front foot.
struct FootShape {
  Role role = Role::none;
  double leg_m = 0;               // from the top of the leg to the sole, at rest
  double rest_m = 0;              // the sole's height at rest
  FootPoint ball;                 // below the ball of the foot: JointSole::place
  std::vector<FootPoint> points;  // that may touch the ground
};

// Feet of a skeleton that have a sole and a leg. Their points are the vertices that are farthest down, and down to each
// side, of those that follow the foot and what is below it; without vertices the ball, and the heel below the ankle.
// meshes: of the skeleton, as in build_roles().
std::vector<FootShape> find_foot_points(const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes);

}  // namespace marrow::cook
