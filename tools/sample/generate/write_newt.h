// Writes the newt as one binary glTF file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clips.h"
#include "face.h"
#include "isosurface.h"
#include "weights.h"

namespace marrow::sample {

struct Model {
  Surface body;
  std::vector<glm::vec3> normals, colours;
  std::vector<VertexWeights> weights;
  std::vector<RigidPart> face;
  std::vector<Clip> clips;
};

// The bytes of the file.
std::string make_glb(const Model& model);
// Clips with the nodes that they move, and without meshes: what a clip pack is cooked of.
std::string make_moves_glb(const std::vector<RigidPart>& face, const std::vector<Clip>& clips);

}  // namespace marrow::sample
