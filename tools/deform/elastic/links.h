// Which voxels of a mesh hang together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deform/skinned_mesh.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {

// Neighbouring solid voxels are linked, unless a surface goes through both, the surfaces follow joints of which less
// than 15 % are the same, and they have no vertex in common. Refers to `voxels`.
class Links {
 public:
  Links(const Voxels& voxels, const SkinnedMesh& mesh);
  // Of two solid cells beside each other.
  bool linked(std::size_t a, std::size_t b) const;

 private:
  static constexpr std::size_t kMostVertices = 24;
  static constexpr std::size_t kMostJoints = 12;
  struct Surface {
    std::vector<std::uint32_t> vertices;  // of the triangles that touch the voxel, ascending; the first so many
    std::vector<Influence> weights;       // their sum, by ascending joint
    double sum = 0;
  };
  void add(std::size_t triangle, const SkinnedMesh& mesh, Surface& surface) const;

  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> number_;  // of a cell, among the surfaces
  std::vector<Surface> surfaces_;
};

}  // namespace marrow::deform
