// A generated mesh of any size in the runtime's own layout: every vertex has as many influences as asked.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

inline constexpr std::uint32_t kMeshJoints = 67;

class GeneratedMesh {
 public:
  // Vertex v follows palette entries b … b + influences - 1 (mod joints) with b = joints · v / vertex_count, by weights
  // of noise. vertex_count: ≥ joints. The animation-space residual is not zero.
  GeneratedMesh(std::uint32_t vertex_count, std::uint32_t influences, std::uint32_t joints = kMeshJoints);
  GeneratedMesh(const GeneratedMesh&) = delete;
  GeneratedMesh& operator=(const GeneratedMesh&) = delete;

  // Positions, normals, tangents and residual; two triangles a slot, each slot in six, as in a grid, unless there are
  // more than 65 536 slots; entry j is joint j, bound where it is.
  const Mesh& view() const { return mesh_; }

 private:
  std::vector<Run> runs_;
  std::vector<std::uint16_t> sets_;
  std::vector<float> skin_, normals_, tangents_, residual_;
  std::vector<std::uint16_t> joints_;
  std::vector<std::uint16_t> indices_;
  std::vector<Affine> inverse_bind_;
  Mesh mesh_;
};

}  // namespace marrow::tools
