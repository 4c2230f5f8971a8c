#include "deform/rotation_of_matrix.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-30 && std::isfinite(length) ? v / length : otherwise;
}

}  // namespace

glm::dmat3 rotation_of(const glm::dmat3& m) {
  const glm::dvec3 x = unit_or(m[0], {1, 0, 0});
  const glm::dvec3 other = std::abs(x.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 y = unit_or(m[1] - x * glm::dot(x, m[1]), glm::normalize(other - x * glm::dot(x, other)));
  return {x, y, glm::cross(x, y)};
}

glm::dquat quaternion_of(const glm::dmat3& rotation) {
  const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
  return q.w < 0 ? -q : q;
}

}  // namespace marrow::deform
