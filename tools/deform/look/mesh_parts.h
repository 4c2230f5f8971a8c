// The connected parts of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

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
