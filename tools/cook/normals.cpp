#include "cook/normals.h"

#include <cmath>

namespace marrow::cook {
namespace {

// Angle between two edges by halves of the unit vectors' sum and difference: exact near 0 and π, unlike acos.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b));
}

}  // namespace

void generate_normals(RawPrimitive& primitive) {
  std::vector<glm::dvec3> sums(primitive.positions.size(), glm::dvec3(0));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* const corner = &primitive.indices[i];
    const glm::dvec3 p[3] = {primitive.positions[corner[0]], primitive.positions[corner[1]],
                             primitive.positions[corner[2]]};
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(normal);
    if (!(area > 0)) continue;
    for (int c = 0; c < 3; ++c) {
      const glm::dvec3 a = glm::normalize(p[(c + 1) % 3] - p[c]), b = glm::normalize(p[(c + 2) % 3] - p[c]);
      sums[corner[c]] += normal / area * angle_between(a, b);
    }
  }
  primitive.normals.clear();
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    primitive.normals.push_back(length > 1e-12 ? glm::vec3(sum / length) : glm::vec3(0, 1, 0));
  }
  primitive.tangents.clear();
}

void generate_target_normals(RawPrimitive& primitive) {
  for (RawTarget& target : primitive.targets) {
    target.normals.clear();
    if (target.positions.empty()) continue;
    RawPrimitive moved;
    moved.indices = primitive.indices;
    for (std::size_t v = 0; v < primitive.positions.size(); ++v)
      moved.positions.push_back(primitive.positions[v] + target.positions[v]);
    generate_normals(moved);
    for (std::size_t v = 0; v < primitive.positions.size(); ++v)
      target.normals.push_back(moved.normals[v] - primitive.normals[v]);
  }
}

}  // namespace marrow::cook
