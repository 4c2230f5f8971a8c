#include "deform/fit/correction.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace marrow::deform {

Matrix blended(const std::vector<Influence>& influences, const Pose& pose) {
  Matrix sum(0.0);
  for (const Influence& i : influences) sum += pose[i.joint] * i.weight;
  return sum;
}

std::optional<glm::dvec3> correction(const Matrix& m, const glm::dvec3& missing) {
  constexpr double kLeastVolume = 1e-3;  // of that of a cube with the longest edge
  const glm::dmat3 linear = linear_of(m);
  const double edge = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
  if (!(std::abs(glm::determinant(linear)) > kLeastVolume * edge * edge * edge)) return std::nullopt;
  return glm::inverse(linear) * missing;
}

}  // namespace marrow::deform
