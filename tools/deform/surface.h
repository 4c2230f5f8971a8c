// What smoothing and normals need of a mesh: who is whose neighbour; and its connected parts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

enum class EdgeWeights {
  uniform,    // every neighbour counts alike: the umbrella operator
  cotangent,  // by the angles opposite the edge in the bind pose, none below 0 (Pinkall and Polthier 1993)
};

class Surface {
 public:
  explicit Surface(const SkinnedMesh& mesh, EdgeWeights weights = EdgeWeights::uniform);

  std::size_t size() const { return first_.size() - 1; }
  std::span<const std::uint32_t> neighbours(std::size_t vertex) const {
    return {neighbours_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }
  // Of the neighbours; they sum to 1, or all are 0 for a vertex that stands alone.
  std::span<const double> weights(std::size_t vertex) const {
    return {weights_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }
  // On an edge that has not two triangles.
  bool on_border(std::size_t vertex) const { return border_[vertex] != 0; }

  // One Laplacian step: every vertex goes `step` of the way to the weighted mean of its neighbours; those on a border
  // and those that stand alone stay. T: anything with + and times a double.
  template <class T>
  void smooth(std::vector<T>& values, double step, std::vector<T>& scratch) const;

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> neighbours_;
  std::vector<double> weights_;
  std::vector<char> border_;
};

// Shares of vertices, 0 … 1: wider by some rings of neighbours, then smoothed by so many steps. All of a share stays
// where there are as many rings as steps.
void soften(const Surface& surface, int rings, int steps, std::vector<double>& shares);

// The normal of a triangle, as long as its doubled area.
inline glm::dvec3 doubled_area(const Positions& p, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return glm::cross(p[b] - p[a], p[c] - p[a]);
}

// Of all triangles.
double area(const Positions& positions, std::span<const std::uint32_t> indices);

// What closed surfaces enclose; below 0 where triangles face inwards.
double volume(const Positions& positions, std::span<const std::uint32_t> indices);

// Area-weighted vertex normals, unit; 0 where all triangles round a vertex have no area.
std::vector<glm::dvec3> vertex_normals(const Positions& positions, std::span<const std::uint32_t> indices);

template <class T>
void Surface::smooth(std::vector<T>& values, double step, std::vector<T>& scratch) const {
  scratch = values;
  for (std::size_t v = 0; v < size(); ++v) {
    const std::span<const std::uint32_t> around = neighbours(v);
    if (around.empty() || on_border(v)) continue;
    const std::span<const double> w = weights(v);
    T mean = scratch[around[0]] * w[0];
    for (std::size_t i = 1; i < around.size(); ++i) mean = mean + scratch[around[i]] * w[i];
    values[v] = scratch[v] * (1 - step) + mean * step;
  }
}

// Sets that are united, each known by its least member.
class Unions {
 public:
  explicit Unions(std::size_t count);
  std::uint32_t root(std::uint32_t i) {
    while (up_[i] != i) i = up_[i] = up_[up_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> up_;  // of a member another of its set, at most itself
};

// Parts have no triangle in common; a vertex without a triangle is in none.
class MeshParts {
 public:
  // Refers to the mesh.
  explicit MeshParts(const SkinnedMesh& mesh);

  // The vertices of each part, ascending.
  const std::vector<std::vector<std::uint32_t>>& vertices() const { return vertices_; }
  // Of each part the mean over its edges of (length / length in the bind pose - 1)².
  std::vector<double> stretches(const Positions& posed) const;

 private:
  const SkinnedMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> vertices_;
  std::vector<std::uint32_t> part_of_;  // of a vertex
};

}  // namespace marrow::deform
