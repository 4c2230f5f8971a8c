// Weights that were painted by `marrow view`: all weights of some vertices, by where these are in the bind pose.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::cook {

// joint: of PaintedMesh::joints.
struct PaintedVertex {
  glm::vec3 place{0};                         // in the bind pose, mesh space
  std::vector<deform::Influence> influences;  // by ascending joint; weights > 0 that sum to 1
};

struct PaintedMesh {
  std::string name;                 // of the mesh; of one without a name, its node's
  std::vector<std::string> joints;  // names, each once
  std::vector<PaintedVertex> vertices;
};

// JSON: docs/cooking/skin_weights.md. path: for messages. Throws tools::Failure at the place in the text: invalid;
// unsupported for another version.
std::vector<PaintedMesh> read_painted(const std::string& path, std::string_view text);

// What read_painted() reads, a vertex a line, places and weights to the bit of a float.
std::string text_of_painted(std::span<const PaintedMesh> meshes);

}  // namespace marrow::cook
