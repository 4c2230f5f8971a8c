// Skin weights that the source does not have: made from bones, smoothed, painted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cook/build.h"
#include "cook/scene/raw.h"
#include "deform/weights/auto_weights.h"

namespace marrow::cook {

// Before build_scene's stages. Meshes without weights get some (RawPrimitive::influences) and a skin
// (RawInstance::skin):
// - a mesh that the file gives a skin, that skin;
// - any other that hangs on nothing that moves, the joints of the file's only skin, or of a file without skins the
//   nodes that clips move and that draw nothing themselves. It is bound where the nodes' rest poses put mesh and
//   joints.
// Meshes that have weights keep them. Smoothing and painting then go for all meshes that are drawn with a skin. Says in
// scene.warnings what was done. Throws tools::Failure: usage if an option fits nothing, invalid for nothing to bind to
// or a bad mask, unsupported for too many vertices.
void bind_weights(RawScene& scene, const WeightOptions& options);

inline constexpr double kFarthestPlace = 1e29;  // of a coordinate: squares of it are finite

inline std::size_t to_index(int i) {
  return static_cast<std::size_t>(i);
}

// For each node the nearest at or above it for which `known` is set; the topmost if it is set for none.
std::vector<std::size_t> nearest_known(const RawScene& scene, std::vector<char> known);

// scene_from_node of every node, at rest.
std::vector<glm::dmat4> rest_of_nodes(const RawScene& scene);

// Bones of joints, each from a joint to the nearest joints below it. One without any reaches to its nodes' children
// that draw nothing; without those, half as far as its parent's bone does to it, straight on. space_from_joint: one a
// joint; joints whose matrix is not finite or cannot be inverted have no bones.
std::vector<deform::Bone> bones_of(const RawScene& scene, const std::vector<int>& joints,
                                   const std::vector<glm::dmat4>& space_from_joint);
bool is_usable(const glm::dmat4& matrix);

// Painted weights, of all meshes that are drawn with a skin. Notes the masks in scene.reads.
void paint_weights(RawScene& scene, const std::vector<PaintRule>& rules);
// A mask as RawScene::reads has it. Throws tools::Failure: io, invalid if it is absurdly large.
RawRead read_of_mask(const std::string& path);

// "/meshes/2" of its primitives' pointers.
std::string pointer_of(const RawMesh& mesh);

}  // namespace marrow::cook
