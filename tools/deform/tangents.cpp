#include "deform/tangents.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace marrow::deform {
namespace {

constexpr double kFlat = 1e-3;  // of a ring's areas, below which they cancel out

// Perpendicular to a unit vector, and unit.
glm::dvec3 perpendicular(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

// q as the joints of `vertex` would have it: what others have goes to that of its joints which q follows most, or else
// to the vertex's heaviest.
std::vector<Coordinate> seen_by(const std::vector<Coordinate>& vertex, const std::vector<Coordinate>& q) {
  std::vector<Coordinate> out = vertex;
  const auto by_weight = [](const Coordinate& a, const Coordinate& b) { return a.q.w < b.q.w; };
  auto heir = std::max_element(vertex.begin(), vertex.end(), by_weight) - vertex.begin();
  for (Coordinate& c : out) c.q = glm::dvec4(0);
  glm::dvec4 left(0);
  double most = 0;
  for (const Coordinate& c : q) {
    const auto same = std::ranges::find(out, c.joint, &Coordinate::joint);
    (same != out.end() ? same->q : left) += c.q;
    if (same == out.end() || !(c.q.w > most)) continue;
    most = c.q.w;
    heir = same - out.begin();
  }
  out[static_cast<std::size_t>(heir)].q += left;
  return out;
}

// Two corners a triangle that follow one at the vertex.
using Ring = std::vector<std::array<std::uint32_t, 2>>;

std::array<std::vector<Coordinate>, 2> tangents_of(std::size_t v, const Coordinates& coordinates, const Positions& rest,
                                                   const Ring& ring, const glm::dvec3& normal) {
  std::array<std::vector<Coordinate>, 2> out = {coordinates[v], coordinates[v]};
  for (std::vector<Coordinate>& tangent : out)
    for (Coordinate& c : tangent) c.q = glm::dvec4(0);
  if (normal == glm::dvec3(0)) return out;
  const glm::dvec3 first = perpendicular(normal);
  const glm::dvec3 axes[2] = {first, glm::cross(normal, first)};
  glm::dvec3 mean(0);
  double areas = 0;
  for (const auto& [k, l] : ring) {
    const glm::dvec3 doubled = glm::cross(rest[k] - rest[v], rest[l] - rest[v]);
    mean += doubled;
    areas += glm::length(doubled);
  }
  const double area = glm::length(mean);
  glm::dvec3 lacks[2] = {axes[0], axes[1]};
  const auto add = [&](std::uint32_t k, const glm::dvec3& across) {
    const std::vector<Coordinate> q = seen_by(coordinates[v], coordinates[k]);
    for (std::size_t a = 0; a < 2; ++a) {
      const double factor = glm::dot(across, glm::cross(mean, axes[a])) / (area * area);
      lacks[a] -= (rest[k] - rest[v]) * factor;
      for (std::size_t j = 0; j < q.size(); ++j) out[a][j].q += (q[j].q - coordinates[v][j].q) * factor;
    }
  };
  for (const auto& [k, l] : ring) {
    if (!(area > kFlat * areas)) break;
    add(k, rest[l] - rest[v]);
    add(l, rest[v] - rest[k]);
  }
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t j = 0; j < out[a].size(); ++j) out[a][j].q += glm::dvec4(lacks[a] * coordinates[v][j].q.w, 0);
  return out;
}

}  // namespace

TangentCoordinates tangent_coordinates(const Coordinates& coordinates, const SkinnedMesh& mesh,
                                       const std::vector<glm::dvec3>& normals) {
  const Positions& rest = mesh.positions;
  const std::vector<std::uint32_t>& indices = mesh.indices;
  std::vector<Ring> rings(rest.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t first = i - i % 3;
    rings[indices[i]].push_back({indices[first + (i + 1) % 3], indices[first + (i + 2) % 3]});
  }
  TangentCoordinates out;
  for (std::size_t v = 0; v < rest.size(); ++v) out.push_back(tangents_of(v, coordinates, rest, rings[v], normals[v]));
  return out;
}

std::vector<glm::dvec3> surface_normals(const TangentCoordinates& tangents, const Pose& pose) {
  std::vector<glm::dvec3> out;
  for (const std::array<std::vector<Coordinate>, 2>& of_vertex : tangents) {
    glm::dvec3 t[2] = {glm::dvec3(0), glm::dvec3(0)};
    for (std::size_t a = 0; a < 2; ++a)
      for (const Coordinate& c : of_vertex[a]) t[a] += pose[c.joint] * c.q;
    glm::dvec3 n = glm::cross(t[0], t[1]);
    if (!of_vertex[0].empty() && glm::determinant(linear_of(pose[of_vertex[0].back().joint])) < 0) n = -n;
    const double length = glm::length(n);
    out.push_back(length > 0 ? n / length : glm::dvec3(0));
  }
  return out;
}

}  // namespace marrow::deform
