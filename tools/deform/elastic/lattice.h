// The inside of a mesh as cells of a lattice, which share corners where the body goes on from one to the next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Places are in sides of a cell, from the lattice's origin; cell (x, y, z) covers [x, x + 1) …
struct Lattice {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Cell {
    glm::ivec3 at{0};
    // At bit 0 of their number in x, bit 1 in y, bit 2 in z.
    std::array<std::uint32_t, 8> nodes{};
    // Across the faces at -x, x, -y, y, -z, z; of several pieces the first.
    std::array<std::uint32_t, 6> beside{};
    float filled = 0;  // the share of it that the body fills
  };

  glm::dvec3 origin{0};
  double side = 1;  // of a cell, in the mesh's units
  std::vector<Cell> cells;
  std::vector<glm::ivec3> nodes;       // their places
  std::vector<float> filled_around;    // of a node: of the 4³ cells round it the share that is filled
  std::vector<std::uint32_t> cell_of;  // of a vertex, or kNone

  glm::dvec3 to_lattice(const glm::dvec3& p) const { return (p - origin) / side; }
};

// For so many vertices: 10 000, of which less makes creases, and fewer where there are not vertices enough to show any.
std::size_t cells_for(std::size_t vertices);

// About so many cells, each of 3³ voxels; fewer where the box of the mesh is large and what fills it thin. Where two
// surfaces meet whose weights have hardly anything in common, as two fingers, voxels are not linked; pieces of a cell
// that are not are cells of their own. So corners are one only where cells are linked across a face: Nesme, Kry,
// Jeřábková, Faure, "Preserving topology and elasticity for embedded deformable models", ACM TOG 28(3), 2009.
// Bodies without a vertex of the mesh are left out. Memory: at most 90 MB on the way, then 2 MB.
Lattice make_lattice(const SkinnedMesh& mesh, std::size_t cells);

}  // namespace marrow::deform
