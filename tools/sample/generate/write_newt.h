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

}  // namespace marrow::sample
