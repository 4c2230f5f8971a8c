// The newt's rigid parts: glossy eyes, eyelids, and the line of its mouth.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "isosurface.h"
#include "shape.h"

namespace marrow::sample {

// A mesh that hangs from the head joint without being skinned.
struct RigidPart {
  std::string name;
  glm::vec3 at{0};             // model space, at rest
  glm::quat turn{1, 0, 0, 0};  // model space, at rest
  Surface mesh;                // in the part's own frame
  std::vector<glm::vec3> normals, colours;
};

// Order of the parts that make_face() returns.
enum FacePart : int { kEyeL, kEyeR, kLidL, kLidR, kMouth, kFacePartCount };

// How an eye is turned at rest, in model space: it looks ahead, a little outwards and up.
glm::quat eye_turn(int side);

// The turn of an eyelid in its eye's own frame; 0 is wide open, 1 is shut.
glm::quat lid_turn(int side, float shut);
inline constexpr float kLidAtRest = .10f;

std::vector<RigidPart> make_face(const Shape& shape);

}  // namespace marrow::sample
