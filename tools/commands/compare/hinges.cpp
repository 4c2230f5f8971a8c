#include "commands/compare/hinges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "deform/surface.h"

namespace marrow::tools {

Shape::Shape(const deform::SkinnedMesh& m) : mesh(m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    const auto [at, is_new] = first.try_emplace(std::minmax(a, b), i / 3);
    if (!is_new) hinges.emplace_back(at->second, i / 3);
  }
  bind_normals = deform::vertex_normals(mesh.positions, mesh.indices);
  bind_angles = angles(mesh.positions);
}

std::vector<double> Shape::angles(const deform::Positions& p) const {
  std::vector<glm::dvec3> normals;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::dvec3 n =
        glm::cross(p[mesh.indices[t + 1]] - p[mesh.indices[t]], p[mesh.indices[t + 2]] - p[mesh.indices[t]]);
    const double length = glm::length(n);
    normals.push_back(length > 0 ? n / length : glm::dvec3(0));
  }
  std::vector<double> out;
  for (const auto& [a, b] : hinges)
    out.push_back(normals[a] == glm::dvec3(0) || normals[b] == glm::dvec3(0)
                      ? 0.0
                      : std::acos(std::clamp(glm::dot(normals[a], normals[b]), -1.0, 1.0)));
  return out;
}

}  // namespace marrow::tools
