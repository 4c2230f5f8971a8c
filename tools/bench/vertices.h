// A generated mesh of any size in the runtime's own layout: every vertex has as many influences as asked.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

inline constexpr std::uint32_t kMeshJoints = 67;

class GeneratedMesh {
 public:
  // Vertex v follows palette entries b … b + influences - 1 (mod 67) with b = 67 v / vertex_count, by weights of noise.
  // vertex_count: ≥ 67. The animation-space residual is not zero.
  GeneratedMesh(std::uint32_t vertex_count, std::uint32_t influences);
  GeneratedMesh(const GeneratedMesh&) = delete;
  GeneratedMesh& operator=(const GeneratedMesh&) = delete;

  // Positions, normals, tangents and residual; joints and bind matrices are not needed for skinning.
  const Mesh& view() const { return mesh_; }

 private:
  std::vector<Run> runs_;
  std::vector<std::uint16_t> sets_;
  std::vector<float> skin_, normals_, tangents_, residual_;
  Mesh mesh_;
};

}  // namespace marrow::tools
