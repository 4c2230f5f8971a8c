// A whole clip at even moments: what curves, trails and ghosts are drawn from.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "pose/evaluate.h"

namespace marrow::tools {

// Of one joint over a clip, a row a moment.
struct JointCurves {
  std::vector<float> translation[3];   // metres, from the parent
  std::vector<float> rotation_deg[3];  // about x, then y, then z of the parent's axes; without jumps of whole turns
  std::vector<float> scale[3];
  std::vector<glm::vec3> places;  // model space
};

// Poses `play` at `moments` even moments, its first and its end among them, as the clip alone has it. moments: ≥ 2.
// Cost: as many poses.
JointCurves record_joint(const File& file, const Play& play, std::uint32_t skeleton, std::uint32_t joint, int moments);

// A unit quaternion x y z w as angles about the parent's x, y and z axes, in this order, degrees: rotation =
// rotate(z) · rotate(y) · rotate(x). The angle about y is within ±90°.
glm::vec3 angles_deg(const float (&rotation)[4]);

}  // namespace marrow::tools
