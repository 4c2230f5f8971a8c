// From which side one sees best what two deformers make differently of a character.
#pragma once

#include <glm/vec3.hpp>

#include "pose/evaluate.h"
#include "render/camera.h"

namespace marrow::tools {

// A ball that a picture is to show, model space.
struct Part {
  glm::vec3 centre{0};
  float radius = 0;
};

struct Seen {
  Orbit side;       // its yaw and pitch
  float share = 0;  // of a picture of the part, how much another it is, 0 … 1; what is hidden changes nothing
};

// Looks from a ring of sides at two heights. The usual side is taken where it shows nearly as much as the best. a, b: a
// posed mesh a mesh of `file`.
Seen clearest_side(const File& file, const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b,
                   const Part& part);

// Points that a camera frames to show the part.
std::vector<glm::vec3> framed(const Part& part);

}  // namespace marrow::tools
