#include "deform/rotations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include "common/elementary.h"

namespace marrow::deform {
namespace {

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-30 && std::isfinite(length) ? v / length : otherwise;
}

double squares(const glm::dmat3& m) {
  return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
}

// The edge of a cube as long, over all, as the matrix' columns.
double size_of(const glm::dmat3& m) {
  return std::sqrt(squares(m) / 3);
}

}  // namespace

glm::dmat3 rotation_of(const glm::dmat3& m) {
  const glm::dvec3 x = unit_or(m[0], {1, 0, 0});
  const glm::dvec3 other = std::abs(x.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 y = unit_or(m[1] - x * glm::dot(x, m[1]), glm::normalize(other - x * glm::dot(x, other)));
  return {x, y, glm::cross(x, y)};
}

bool has_rotation(const glm::dmat3& m) {
  const double size = size_of(m);
  return std::isfinite(size) && size > 1e-30 && std::abs(glm::determinant(m / size)) > 1e-6;
}

glm::dmat3 nearest_rotation(const glm::dmat3& m) {
  if (!has_rotation(m)) return glm::dmat3(1.0);
  glm::dmat3 x = m / (glm::determinant(m) < 0 ? -size_of(m) : size_of(m));
  // From a volume of a millionth nine steps lead there; the number is a bound.
  for (int i = 0; i < 20; ++i) {
    const glm::dmat3 other = glm::inverseTranspose(x);
    // Brings the two to one size, so that it does not take more steps the flatter the matrix is.
    const double scale = std::sqrt(std::sqrt(squares(other) / squares(x)));
    const glm::dmat3 next = (x * scale + other / scale) * 0.5;
    const double moved = squares(next - x);
    x = next;
    if (moved < 1e-20) break;  // which quadratic convergence takes to less than rounding
  }
  return x;
}

glm::dquat quaternion_of(const glm::dmat3& rotation) {
  const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
  return q.w < 0 ? -q : q;
}

std::vector<glm::dquat> local_rotations(const Pose& pose, const std::vector<int>& parents) {
  std::vector<glm::dmat3> rotations;
  for (const Matrix& m : pose) rotations.push_back(rotation_of(linear_of(m)));
  std::vector<glm::dquat> out;
  for (std::size_t j = 0; j < pose.size(); ++j)
    out.push_back(parents[j] < 0
                      ? glm::dquat(1, 0, 0, 0)
                      : quaternion_of(glm::transpose(rotations[static_cast<std::size_t>(parents[j])]) * rotations[j]));
  return out;
}

std::vector<glm::dquat> rotations_of(const Pose& pose) {
  std::vector<glm::dquat> out;
  for (const Matrix& m : pose) out.push_back(quaternion_of(nearest_rotation(linear_of(m))));
  return out;
}

const Influence& largest(const std::vector<Influence>& influences) {
  return *std::max_element(influences.begin(), influences.end(),
                           [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
}

glm::dvec3 by_dual_quaternion(const std::vector<Influence>& influences, const std::vector<glm::dquat>& rotations,
                              const Pose& pose, const glm::dvec3& bind) {
  if (influences.size() == 1) return transform(pose[influences[0].joint], bind);
  glm::dquat twice_dual(0, 0, 0, 0);
  const glm::dquat real = blend_rotations(influences, rotations, [&](const Influence& i, const glm::dquat& part) {
    const glm::dvec3 place = transform(pose[i.joint], bind);
    twice_dual = twice_dual + glm::dquat(0, place.x, place.y, place.z) * part;
  });
  const glm::dquat moved = twice_dual * glm::conjugate(real);
  return glm::dvec3(moved.x, moved.y, moved.z) / glm::dot(real, real);
}

glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double share) {
  const double cosine = glm::dot(a, b);
  const glm::dquat nearer = cosine < 0 ? -b : b;
  const double size = cosine < 0 ? -cosine : cosine;
  if (size > 1 - std::numeric_limits<double>::epsilon()) return a * (1 - share) + nearer * share;
  const double angle = tools::arc_cosine(size);
  return (a * tools::sine((1 - share) * angle) + nearer * tools::sine(share * angle)) / tools::sine(angle);
}

}  // namespace marrow::deform
