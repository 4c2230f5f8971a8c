#include "deform/tangents.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

// Perpendicular to a unit vector, and unit.
glm::dvec3 perpendicular(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

}  // namespace

TangentOperator::TangentOperator(const Surface& surface, const Positions& rest, const std::vector<glm::dvec3>& normals)
    : surface_(surface) {
  constexpr double kFlat = 1e-6;  // of the larger extent of a ring, squared
  for (std::size_t v = 0; v < surface.size(); ++v) {
    first_.push_back(coefficients_.size());
    const auto around = surface.neighbours(v);
    coefficients_.resize(coefficients_.size() + around.size(), {0, 0});
    if (normals[v] == glm::dvec3(0)) continue;
    const glm::dvec3 s = perpendicular(normals[v]), t = glm::cross(normals[v], s);
    double ss = 0, st = 0, tt = 0;
    std::vector<std::array<double, 2>> ring;
    for (const std::uint32_t k : around) {
      const glm::dvec3 edge = rest[k] - rest[v];
      ring.push_back({glm::dot(edge, s), glm::dot(edge, t)});
      ss += ring.back()[0] * ring.back()[0];
      st += ring.back()[0] * ring.back()[1];
      tt += ring.back()[1] * ring.back()[1];
    }
    const double det = ss * tt - st * st;
    if (!(det > kFlat * (ss + tt) * (ss + tt))) continue;
    for (std::size_t k = 0; k < ring.size(); ++k)
      coefficients_[first_[v] + k] = {(tt * ring[k][0] - st * ring[k][1]) / det,
                                      (ss * ring[k][1] - st * ring[k][0]) / det};
  }
}

std::array<glm::dvec3, 2> TangentOperator::at(std::size_t vertex, const Positions& positions) const {
  std::array<glm::dvec3, 2> out{};
  const auto around = surface_.neighbours(vertex);
  for (std::size_t k = 0; k < around.size(); ++k) {
    const glm::dvec3 edge = positions[around[k]] - positions[vertex];
    const std::array<double, 2>& c = coefficients(vertex, k);
    out[0] += edge * c[0];
    out[1] += edge * c[1];
  }
  return out;
}

}  // namespace marrow::deform
