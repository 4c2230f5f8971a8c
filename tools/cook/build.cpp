#include "cook/build.h"

#include <algorithm>

#include "common/failure.h"

namespace marrow::cook {

glm::dmat4 local_matrix(const RawNode& node) {
  glm::dmat4 m = glm::mat4_cast(node.rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= node.scale[axis];
  m[3] = glm::dvec4(node.translation, 1.0);
  return m;
}

Affine to_affine(const glm::dmat4& m) {
  Affine a;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) a.rows[row][column] = static_cast<float>(m[column][row]);
  return a;
}

namespace {

// A file may be a library: meshes that no node draws. Each is hung on a node of its own then.
void place_unplaced_meshes(RawScene& scene) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    RawNode node;
    node.name = scene.meshes[i].name;
    scene.instances.push_back({static_cast<int>(scene.nodes.size()), static_cast<int>(i), kNone});
    scene.nodes.push_back(node);
  }
  if (!scene.meshes.empty())
    scene.warnings.push_back({"/nodes", "meshes-without-nodes", "no node draws a mesh; each is placed at the origin"});
}

bool has_triangles(const RawScene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const RawInstance& instance) {
    return !scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives.empty();
  });
}

}  // namespace

BuiltScene build_scene(RawScene& scene, const CookOptions& options) {
  BuiltScene out;
  if (scene.instances.empty()) place_unplaced_meshes(scene);
  if (scene.instances.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-meshes", "the file has no mesh to cook");
  if (!has_triangles(scene))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-triangles",
                         "no mesh in the scene has triangles to cook");
  out.skeleton = build_skeleton(scene);
  for (const RawClip& clip : scene.clips) out.clips.push_back(build_clip(clip, out.skeleton));
  build_meshes(scene, options, out);
  return out;
}

}  // namespace marrow::cook
