#include "commands/compare/hinges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "deform/surface.h"

namespace marrow::tools {
namespace {

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

}  // namespace

Shape::Shape(const deform::SkinnedMesh& m) : mesh(m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    const auto [at, is_new] = first.try_emplace(std::minmax(a, b), i / 3);
    if (!is_new) hinges.emplace_back(at->second, i / 3);
  }
  bind_normals = deform::vertex_normals(mesh.positions, mesh.indices);
  bind_angles = angles(mesh.positions);
  for (const double angle : bind_angles) bind_turns_.emplace_back(std::cos(angle), std::sin(angle));
}

std::vector<glm::dvec3> Shape::normals(const deform::Positions& p) const {
  std::vector<glm::dvec3> out;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::dvec3 n =
        glm::cross(p[mesh.indices[t + 1]] - p[mesh.indices[t]], p[mesh.indices[t + 2]] - p[mesh.indices[t]]);
    const double length = glm::length(n);
    out.push_back(length > 0 ? n / length : glm::dvec3(0));
  }
  return out;
}

std::vector<double> Shape::angles(const deform::Positions& p) const {
  const std::vector<glm::dvec3> of = normals(p);
  std::vector<double> out;
  for (const auto& [a, b] : hinges)
    out.push_back(of[a] == glm::dvec3(0) || of[b] == glm::dvec3(0) ? 0.0 : angle_between(of[a], of[b]));
  return out;
}

// A hinge that is folded less than the sharpest so far shows that by the cosine alone.
double Shape::sharpest_rad(const deform::Positions& p) const {
  constexpr double kUnsure = 1e-9;
  const std::vector<glm::dvec3> of = normals(p);
  double out = 0, cosine = 1, sine = 0;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const auto [a, b] = hinges[h];
    if (of[a] == glm::dvec3(0) || of[b] == glm::dvec3(0) || bind_angles[h] + out >= std::numbers::pi) continue;
    const auto [bind_cosine, bind_sine] = bind_turns_[h];
    if (glm::dot(of[a], of[b]) > bind_cosine * cosine - bind_sine * sine + kUnsure) continue;
    const double beyond = angle_between(of[a], of[b]) - bind_angles[h];
    if (!(beyond > out)) continue;
    out = beyond;
    cosine = std::cos(out);
    sine = std::sin(out);
  }
  return out;
}

}  // namespace marrow::tools
