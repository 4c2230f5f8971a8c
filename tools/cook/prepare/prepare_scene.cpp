#include "cook/prepare/prepare_scene.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/failure.h"
#include "cook/prepare/add_skeleton.h"
#include "cook/prepare/bind_weights.h"
#include "cook/prepare/idle_motion.h"
#include "cook/prepare/weights_over_time.h"
#include "cook/skeleton/build_skeletons.h"

namespace marrow::cook {
namespace {

constexpr std::uint64_t kMostFinerTriangles = 4'000'000;  // of all meshes
constexpr std::uint64_t kMostFinerChanges = 32'000'000;   // of vertices by morph targets

// A file may be a library: meshes that no node draws. Each is hung on a node of its own then.
RawScene place_unplaced_meshes(RawScene scene, Notes& notes) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (scene.meshes[i].primitives.empty()) continue;
    RawNode node;
    node.name = scene.meshes[i].name;
    scene.instances.push_back(
        {static_cast<int>(scene.nodes.size()), static_cast<int>(i), kNone, scene.meshes[i].weights, kNone});
    scene.nodes.push_back(node);
  }
  if (!scene.instances.empty())
    notes.warnings.push_back({"/nodes", "meshes-without-nodes", "no node draws a mesh; each is placed at the origin"});
  return scene;
}

// Nodes that would be joints in a file without meshes.
bool has_joints(const RawScene& scene) {
  const auto moves = [](const RawNode& node) { return node.moved_by_game && node.in_scene; };
  return !skins_in_use(scene).empty() || std::ranges::any_of(scene.nodes, moves) ||
         std::ranges::any_of(scene.clips, [&](const RawClip& clip) {
           return std::ranges::any_of(clip.channels, [&](const RawChannel& channel) {
             return scene.nodes[static_cast<std::size_t>(channel.node)].in_scene;
           });
         });
}

// What lost all its triangles to a mend is drawn nowhere, and no stage need know of it.
RawScene without_empty_meshes(RawScene scene) {
  const std::size_t lost = std::erase_if(scene.instances, [&](const RawInstance& instance) {
    return scene.meshes[to_index(instance.mesh)].primitives.empty();
  });
  if (lost > 0 && scene.instances.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-triangles",
                         "no mesh in the scene has triangles to cook");
  return scene;
}

void check_something_to_cook(const RawScene& scene, Notes& notes) {
  if (scene.instances.empty() && !has_joints(scene))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-meshes",
                         scene.draws_elsewhere
                             ? "the scene that is cooked has no mesh to draw, no skin and no node that "
                               "moves; --scene takes another"
                             : "the file has no mesh, no skin and no node that moves");
  if (scene.instances.empty() && !scene.is_capture)
    notes.warnings.push_back(
        {"/meshes", "no-meshes", "only skeletons and clips are cooked; --clips-only makes a clip pack of them"});
}

}  // namespace

void check_subdivision(const RawScene& scene, int steps) {
  const int shift = 2 * steps;
  std::set<int> drawn;
  for (const RawInstance& instance : scene.instances) drawn.insert(instance.mesh);
  std::uint64_t triangles = 0, changes = 0;
  for (const int m : drawn) {
    const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
    for (const RawPrimitive& p : mesh.primitives) {
      const std::uint64_t finer = std::uint64_t{p.indices.size() / 3} << shift;
      triangles += finer;
      // Each step adds at most three vertices a triangle, so all of them at most as many as there are triangles then.
      changes += (p.positions.size() + finer) * p.targets.size();
      if (triangles > kMostFinerTriangles)
        throw tools::Failure(tools::Exit::unsupported, scene.source, p.pointer, "too-many-triangles",
                             fmt::format("with --subdivide {} there would be more than {} in all; take fewer steps",
                                         steps, kMostFinerTriangles));
      if (changes > kMostFinerChanges)
        throw tools::Failure(
            tools::Exit::unsupported, scene.source, p.pointer, "too-many-targets",
            fmt::format("with --subdivide {} they would move more than {} vertices in all; take fewer steps", steps,
                        kMostFinerChanges));
    }
  }
}

RawScene prepare_scene(RawScene scene, const PrepareOptions& options, Notes& notes) {
  if (scene.instances.empty() && !scene.draws_elsewhere) scene = place_unplaced_meshes(std::move(scene), notes);
  scene = without_empty_meshes(std::move(scene));
  if (options.skeleton) {
    RiggedScene rigged = add_skeleton(std::move(scene), options.auto_skeleton, *options.skeleton, notes);
    scene = bind_to(rigged.made, std::move(rigged.scene), options.weights, notes);
  } else if (options.weights.any()) {
    scene = bind_weights(std::move(scene), options.weights, notes);
  }
  if (!options.weights_over_time.empty()) scene = weights_over_time(std::move(scene), options.weights_over_time, notes);
  scene = without_idle_motion(std::move(scene), options.keep, notes);
  check_something_to_cook(scene, notes);
  return scene;
}

}  // namespace marrow::cook
