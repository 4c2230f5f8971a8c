// A canvas in a pose, by linear blend skinning with the weights that are painted.
#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "commands/view/paint/canvas.h"
#include "pose/evaluate.h"

namespace marrow::tools {

struct PosedCanvas {
  std::vector<glm::vec3> places;    // model space
  std::vector<glm::mat4> matrices;  // a place: model_from_mesh
};

// binds: of each group, as bind_matrices() gives them. model_from_joint: of each skeleton.
void pose_canvas(const Canvas& canvas, std::span<const std::vector<glm::mat4>> binds,
                 std::span<const std::vector<Affine>> model_from_joint, PosedCanvas& out);

// Slots of a mesh of the file. As skin_ssd() does it, without tangents.
PosedMesh posed_mesh(const Mesh& mesh, std::span<const std::uint32_t> place_of_slot, const PosedCanvas& posed);

}  // namespace marrow::tools
