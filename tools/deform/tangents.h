// How a surface's tangents follow from its vertices, whatever deforms them.
#pragma once

#include <array>
#include <vector>

#include "deform/surface.h"

namespace marrow::deform {

// For each vertex two tangents, as sums over its neighbours: t = Σ_k c_k (p_k - p). In the pose that they are made of,
// they are perpendicular unit vectors with t₀ × t₁ the normal; in another the image of those under the linear map that
// fits the neighbours best (least squares). So they are linear in the vertices, and their cross product is normal to
// the surface.
class TangentOperator {
 public:
  TangentOperator(const Surface& surface, const Positions& rest, const std::vector<glm::dvec3>& normals);

  // All zero where the neighbours lie on a line.
  const std::array<double, 2>& coefficients(std::size_t vertex, std::size_t neighbour) const {
    return coefficients_[first_[vertex] + neighbour];
  }
  std::array<glm::dvec3, 2> at(std::size_t vertex, const Positions& positions) const;

 private:
  const Surface& surface_;
  std::vector<std::size_t> first_;
  std::vector<std::array<double, 2>> coefficients_;
};

}  // namespace marrow::deform
