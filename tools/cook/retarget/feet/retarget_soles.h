// The soles of a character's feet: the vertices that its ankles and toes carry, and that can be lowest.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cook/retarget/plan/retarget_plan.h"

namespace marrow::cook {

// A vertex: the sum of its joints' maps, each of its own coordinate.
struct SolePoint {
  struct Share {
    std::size_t joint;
    glm::dvec4 coordinate;
  };
  std::vector<Share> shares;
  glm::dvec3 rest{0};  // in the scene

  glm::dvec3 at(const std::vector<glm::dmat4>& model_from_joint) const;
};

// What bends about one joint: the foot about the ankle, toes about theirs.
struct SolePart {
  std::size_t joint = 0;
  std::vector<std::size_t> turned;  // joints with counterparts that bend with it
  std::vector<SolePoint> points;
};

struct Sole {
  std::size_t leg = 0;          // of Legs::tops
  std::vector<SolePart> parts;  // the foot first
  double ground = 0;            // how high it rests
  glm::dvec3 forward{0};        // from the ankle to the farthest point at rest, level, of length 1; 0: nowhere
};

// meshes: of the character, all levels of detail. A foot that none of their vertices follow has points straight below
// its paired joints, as low as the lowest of these.
std::vector<Sole> find_soles(const RetargetPlan& plan, const Legs& legs, const std::vector<Mesh>& meshes);

}  // namespace marrow::cook
