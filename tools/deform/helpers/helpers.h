// Helpers: matrices between those of two joints, for vertices that follow both.
#pragma once

#include <vector>

#include "deform/animation_space.h"

namespace marrow::deform {

struct Helper {
  std::uint32_t first, second;  // entries of the pose
  double share;                 // of second, between 0 and 1
  // In the bind pose: what goes to the mean of where both take it; of dual quaternions the place of joint `second`.
  glm::dvec3 centre;
  bool by_dual_quaternions;
};

// Of the two matrices, each a stretch and then a turn, the blend at `share`: turns as quaternions, the shorter way,
// stretches linearly, and about the centre. A matrix that has lost its volume or is not finite blends with the other as
// numbers. The runtime's build_palette() in double precision.
Matrix blended(const Helper& helper, const Matrix& first, const Matrix& second);

// Adds a matrix for each, in order.
void append_helpers(const std::vector<Helper>& helpers, Pose& pose);

// What linear blend skinning makes of weights over joints and helpers: each helper's weight goes to its two joints by
// its share. Ascending; helpers are numbered from joint_count on.
std::vector<Influence> on_joints(const std::vector<Influence>& weights, const std::vector<Helper>& helpers,
                                 std::uint32_t joint_count);

}  // namespace marrow::deform
