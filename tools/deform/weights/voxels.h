// A mesh as solid voxels. It may be open, cut through itself, or fall into pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Box {
  glm::dvec3 low{0}, high{0};
};
// Of the vertices that triangles use; of all if there are no triangles.
Box box_of(const Positions& positions, std::span<const std::uint32_t> indices);

// Voxel (x, y, z) covers [x, x + 1) … in grid coordinates; the outermost are empty. Solid is what a triangle or a
// vertex touches, what cannot be reached from outside (through faces of voxels), and, so that holes do not empty a
// mesh, what most of the six axes' directions take for inside: those in which a ray leaves the mesh more or less often
// than it enters (after Nooruddin and Turk, "Simplification and repair of polygonal models using volumetric
// techniques", IEEE TVCG 9(2), 2003).
class Voxels {
 public:
  // resolution: on the box's longest side; fewer if more than 400 000 would be solid.
  Voxels(const Positions& positions, std::span<const std::uint32_t> indices, int resolution);

  glm::ivec3 size() const { return size_; }
  double side() const { return side_; }  // of a voxel, in the mesh's units
  glm::dvec3 to_grid(const glm::dvec3& p) const { return (p - origin_) / side_; }
  glm::dvec3 from_grid(const glm::dvec3& grid) const { return origin_ + grid * side_; }
  // Whether the voxel at grid coordinates is there and not one of the outermost.
  bool is_inner(const glm::dvec3& grid) const;
  std::size_t cell_at(const glm::dvec3& grid) const;  // is_inner() must hold
  glm::ivec3 voxel_of(std::size_t cell) const;
  std::ptrdiff_t offset(int x, int y, int z) const {
    return (static_cast<std::ptrdiff_t>(z) * size_.y + y) * size_.x + x;
  }
  std::size_t cells() const { return solid_.size(); }
  bool solid(std::size_t cell) const { return solid_[cell] != 0; }
  // Adds the cells that a triangle of the mesh touches, some twice.
  void add_touched(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                   std::vector<std::size_t>& cells) const;
  // Whether the straight line between two places in grid coordinates stays in solid voxels.
  bool sees(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  std::size_t fill(const Positions& positions, std::span<const std::uint32_t> indices);

  glm::dvec3 origin_{0};
  double side_ = 1;
  glm::ivec3 size_{0};
  std::vector<std::uint8_t> solid_;
};

}  // namespace marrow::deform
