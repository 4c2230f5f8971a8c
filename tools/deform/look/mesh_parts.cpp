#include "deform/look/mesh_parts.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

namespace marrow::deform {

MeshParts::MeshParts(const SkinnedMesh& mesh) : mesh_(mesh), part_of_(mesh.positions.size(), 0) {
  std::vector<std::uint32_t> joined(mesh.positions.size());  // a vertex of the same part, at most the vertex itself
  std::iota(joined.begin(), joined.end(), 0u);
  const auto first_of = [&](std::uint32_t v) {
    while (joined[v] != v) v = joined[v] = joined[joined[v]];
    return v;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = first_of(mesh.indices[i]), b = first_of(mesh.indices[i - i % 3]);
    joined[std::max(a, b)] = std::min(a, b);
  }
  std::vector<char> has_triangle(mesh.positions.size(), 0);
  for (const std::uint32_t v : mesh.indices) has_triangle[v] = 1;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t v = 0; v < joined.size(); ++v) {
    if (has_triangle[v] == 0) continue;
    part_of_[v] = numbers.try_emplace(first_of(v), static_cast<std::uint32_t>(numbers.size())).first->second;
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
