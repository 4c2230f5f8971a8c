#include "deform/surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

struct Edge {
  double cotangents = 0;
  std::uint32_t triangles = 0;
};

// 0 for triangles without area.
double cotangent(const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b) {
  const double sine = glm::length(glm::cross(a - at, b - at));
  return sine > 0 ? glm::dot(a - at, b - at) / sine : 0.0;
}

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, Edge>;

Edges edges_of(const SkinnedMesh& mesh) {
  Edges edges;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.indices[t + i], b = mesh.indices[t + (i + 1) % 3],
                          opposite = mesh.indices[t + (i + 2) % 3];
      if (a == b) continue;
      Edge& edge = edges[std::minmax(a, b)];
      edge.cotangents += cotangent(mesh.positions[opposite], mesh.positions[a], mesh.positions[b]);
      ++edge.triangles;
    }
  }
  return edges;
}

}  // namespace

double weight_of(std::uint32_t joint, const std::vector<Influence>& influences) {
  const auto found = std::ranges::find(influences, joint, &Influence::joint);
  return found == influences.end() ? 0 : found->weight;
}

bool is_finite(const Positions& positions) {
  return std::ranges::all_of(
      positions, [](const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

bool is_finite(const Matrix& m) {
  return std::isfinite(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]) + glm::dot(m[3], m[3]));
}

bool is_finite(const Pose& pose) {
  return std::ranges::all_of(pose, [](const Matrix& m) { return is_finite(m); });
}

double diagonal(const SkinnedMesh& mesh) {
  if (mesh.positions.empty()) return 0;
  glm::dvec3 low = mesh.positions.front(), high = low;
  for (const glm::dvec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(high - low);
}

Surface::Surface(const SkinnedMesh& mesh, EdgeWeights kind) {
  const Edges edges = edges_of(mesh);
  const std::size_t count = mesh.positions.size();
  border_.assign(count, 0);
  std::vector<std::vector<std::pair<std::uint32_t, double>>> around(count);
  for (const auto& [ends, edge] : edges) {
    const auto [a, b] = ends;
    if (edge.triangles != 2) border_[a] = border_[b] = 1;
    const double weight = kind == EdgeWeights::uniform ? 1.0 : std::max(edge.cotangents, 0.0);
    around[a].emplace_back(b, weight);
    around[b].emplace_back(a, weight);
  }
  first_.push_back(0);
  for (std::vector<std::pair<std::uint32_t, double>>& star : around) {
    double sum = 0;
    for (const auto& [vertex, weight] : star) sum += weight;
    for (const auto& [vertex, weight] : star) {
      neighbours_.push_back(vertex);
      weights_.push_back(sum > 0 ? weight / sum : 1.0 / static_cast<double>(star.size()));
    }
    first_.push_back(neighbours_.size());
  }
}

double volume(const Positions& p, std::span<const std::uint32_t> indices) {
  double six = 0;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3)
    six += glm::dot(p[indices[t]], glm::cross(p[indices[t + 1]], p[indices[t + 2]]));
  return six / 6;
}

void soften(const Surface& surface, int rings, int steps, std::vector<double>& shares) {
  std::vector<double> scratch;
  for (int ring = 0; ring < rings; ++ring) {
    scratch = shares;
    for (std::size_t v = 0; v < shares.size(); ++v)
      for (const std::uint32_t k : surface.neighbours(v)) shares[v] = std::max(shares[v], scratch[k]);
  }
  for (int i = 0; i < steps; ++i) surface.smooth(shares, 0.5, scratch);
}

double area(const Positions& p, std::span<const std::uint32_t> indices) {
  double twice = 0;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const glm::dvec3& a = p[indices[t]];
    twice += glm::length(glm::cross(p[indices[t + 1]] - a, p[indices[t + 2]] - a));
  }
  return twice / 2;
}

std::vector<glm::dvec3> vertex_normals(const Positions& positions, std::span<const std::uint32_t> indices) {
  std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0));
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const glm::dvec3 &a = positions[indices[t]], &b = positions[indices[t + 1]], &c = positions[indices[t + 2]];
    const glm::dvec3 twice_area = glm::cross(b - a, c - a);
    for (std::size_t i = 0; i < 3; ++i) normals[indices[t + i]] += twice_area;
  }
  for (glm::dvec3& n : normals) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : glm::dvec3(0);
  }
  return normals;
}

Unions::Unions(std::size_t count) : up_(count) {
  std::iota(up_.begin(), up_.end(), 0u);
}

void Unions::unite(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  up_[std::max(a, b)] = std::min(a, b);
}

MeshParts::MeshParts(const SkinnedMesh& mesh) : mesh_(mesh), part_of_(mesh.positions.size(), 0) {
  Unions joined(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) joined.unite(mesh.indices[i], mesh.indices[i - i % 3]);
  std::vector<char> has_triangle(mesh.positions.size(), 0);
  for (const std::uint32_t v : mesh.indices) has_triangle[v] = 1;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t v = 0; v < part_of_.size(); ++v) {
    if (has_triangle[v] == 0) continue;
    part_of_[v] = numbers.try_emplace(joined.root(v), static_cast<std::uint32_t>(numbers.size())).first->second;
    vertices_.resize(numbers.size());
    vertices_[part_of_[v]].push_back(v);
  }
}

std::vector<double> MeshParts::stretches(const Positions& posed) const {
  std::vector<double> out(vertices_.size(), 0.0), edges(vertices_.size(), 0.0);
  for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
    const std::uint32_t a = mesh_.indices[i], b = mesh_.indices[i % 3 == 2 ? i - 2 : i + 1];
    const double bind = glm::length(mesh_.positions[b] - mesh_.positions[a]);
    if (!(bind > 0)) continue;
    const double stretch = glm::length(posed[b] - posed[a]) / bind - 1;
    out[part_of_[a]] += stretch * stretch;
    ++edges[part_of_[a]];
  }
  for (std::size_t p = 0; p < out.size(); ++p)
    if (edges[p] > 0) out[p] /= edges[p];
  return out;
}

}  // namespace marrow::deform
