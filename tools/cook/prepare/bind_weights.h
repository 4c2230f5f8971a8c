// Skin weights that the source does not have: made from bones, smoothed, painted.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with weights. Meshes that have none get some (RawPrimitive::influences) and a skin (RawInstance::skin):
// - a mesh that the file gives a skin, that skin;
// - any other that hangs on nothing that moves, the joints of the file's only skin, or of a file without skins the
//   nodes that clips move and that draw nothing themselves. It is bound where the nodes' rest poses put mesh and
//   joints.
// Meshes that have weights keep them. Smoothing and painting then go for all meshes that are drawn with a skin. Notes
// what was done and the masks that were read, and takes back the reader's warnings of skins without weights. Throws
// tools::Failure: usage if an option fits nothing, invalid for nothing to bind to or a bad mask, unsupported for too
// many vertices.
RawScene bind_weights(RawScene scene, const WeightOptions& options, Notes& notes);

// Joints that were made for what is drawn.
struct MadeSkeleton {
  std::vector<int> joints;                  // nodes
  std::vector<std::size_t> instances;       // of the scene
  std::vector<glm::dmat4> model_from_mesh;  // one an instance, where it is drawn at rest
};
// Binds all of it to them, whatever skin or weights it has, and goes on as bind_weights() does.
RawScene bind_to(const MadeSkeleton& made, RawScene scene, const WeightOptions& options, Notes& notes);

}  // namespace marrow::cook
