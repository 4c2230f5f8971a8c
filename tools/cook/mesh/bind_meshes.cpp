#include "cook/mesh/bind_meshes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cook/learn/learn.h"
#include "cook/learn/learn_deformers.h"
#include "cook/mesh/scene_scale.h"
#include "cook/mesh/subdivide_mesh.h"
#include "cook/skin/deform_source.h"
#include "cook/skin/primitive_palette.h"
#include "unpack/packed.h"

namespace marrow::cook {
namespace {

const RawSkin& skin_of(const RawScene& scene, int skin) {
  return scene.skins[static_cast<std::size_t>(skin)];
}

// Bound, and learnt from its poses, once for all its primitives.
void bind_mesh(const RawScene& scene, MeshOnSkin which, const BuiltScene& built, const SceneScale& scale,
               const MeshOptions& options, const LearnOptions& learn, BoundMeshes& out, Notes& notes) {
  const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(which.first)];
  const RawSkin& skin = skin_of(scene, which.second);
  auto [binding, report] = learn_binding(scene, mesh, skin, built, learn, bind_to_skin(mesh, notes), notes);
  const MeshGrid grid = mesh_grid(mesh, scale.of(scene, built, which.first), options);
  LearntDeformers learnt = learn_deformers(scene, mesh, skin, built, options, learn, grid, binding, notes);
  binding.deformers = std::move(learnt.deformers);
  binding.report = static_cast<int>(out.learnt.size());
  report.multi_weights = learnt.multi_weights;
  report.pose_space = learnt.pose_space;
  out.bindings.emplace(which, std::move(binding));
  out.learnt.push_back(report);
}

// What is drawn, for all that follows.
void subdivide_meshes(const RawScene& scene, const BuiltScene& built, int steps, BoundMeshes& out, Notes& notes) {
  std::set<int> drawn;
  for (const RawInstance& instance : scene.instances) drawn.insert(instance.mesh);
  for (const int number : drawn) {
    const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(number)];
    std::vector<MovedBy> skins;
    std::vector<SkinBinding*> bindings;
    for (auto& bound : out.bindings) {
      if (bound.first.first != number) continue;
      const SkinBinding& binding = *bindings.emplace_back(&bound.second);
      const RawSkin& skin = skin_of(scene, bound.first.second);
      skins.push_back({&binding, [&mesh, &skin, &binding, &built] {
                         return poses_of_clips(deform_source(mesh, skin, binding, built), binding, built);
                       }});
    }
    FinerMesh finer = subdivide_mesh(mesh, skins, steps);
    if (finer.cut > 0)
      notes.warnings.push_back({mesh.primitives.front().pointer, "influences-dropped",
                                std::to_string(finer.cut) +
                                    " points of the finer mesh would follow more than 8 joints; they get the closest "
                                    "that 8 can do"});
    for (std::size_t s = 0; s < bindings.size(); ++s) *bindings[s] = std::move(finer.bindings[s]);
    out.finer.emplace(number, std::move(finer.mesh));
  }
}

}  // namespace

const RawMesh& BoundMeshes::mesh(const RawScene& scene, int number) const {
  const auto found = finer.find(number);
  return found != finer.end() ? found->second : scene.meshes[static_cast<std::size_t>(number)];
}

bool is_skinned(const RawInstance& instance, const RawPrimitive& primitive) {
  return instance.skin != kNone && !primitive.influences.empty();
}

MeshGrid mesh_grid(const RawMesh& mesh, double scene_scale, const MeshOptions& options) {
  if (options.codec == MeshCodec::none) return {};
  constexpr double kSteps = (1 << 14) - 1;
  glm::dvec3 low(0), high(0);
  bool first = true;
  for (const RawPrimitive& primitive : mesh.primitives) {
    for (const glm::vec3& v : primitive.positions) {
      low = first ? glm::dvec3(v) : glm::min(low, glm::dvec3(v));
      high = first ? glm::dvec3(v) : glm::max(high, glm::dvec3(v));
      first = false;
    }
  }
  const glm::dvec3 size = high - low;
  const double side = std::max({size.x, size.y, size.z});
  const double unit = options.position_error_is_share ? side : scene_scale > 0 ? 1 / scene_scale : 1.0;
  // Half a step along each axis is the farthest.
  double step = options.position_error * unit * 2 / std::sqrt(3.0);
  if (step <= 0) step = side / kSteps;
  constexpr double kMostSteps = (1 << packed::kMaxValueBits) - 1;
  step = std::max(step, side / kMostSteps);
  return {low, step > 0 ? step : 1.0};
}

std::vector<MeshOnSkin> skinned_meshes(const RawScene& scene) {
  std::vector<MeshOnSkin> out;
  for (const RawInstance& instance : scene.instances) {
    const MeshOnSkin which(instance.mesh, instance.skin);
    const auto& primitives = scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
    if (std::ranges::any_of(primitives, [&](const RawPrimitive& p) { return is_skinned(instance, p); }) &&
        std::ranges::find(out, which) == out.end())
      out.push_back(which);
  }
  return out;
}

void learn_ahead(const RawScene& scene, const BuiltScene& built, MeshOnSkin which, const LearnOptions& learn,
                 Notes& notes) {
  const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(which.first)];
  learn_binding(scene, mesh, skin_of(scene, which.second), built, learn, bind_to_skin(mesh, notes), notes);
}

BoundMeshes bind_meshes(const RawScene& scene, const BuiltScene& built, const MeshOptions& options,
                        const LearnOptions& learn, Notes& notes) {
  BoundMeshes out;
  const SceneScale scale(built.skeletons, scene);
  for (const MeshOnSkin& which : skinned_meshes(scene))
    bind_mesh(scene, which, built, scale, options, learn, out, notes);
  if (options.subdivide > 0) subdivide_meshes(scene, built, options.subdivide, out, notes);
  for (auto& [of, binding] : out.bindings)
    binding.part_of = split_primitives(scene.source, out.mesh(scene, of.first), skin_of(scene, of.second).joints.size(),
                                       options.most_entries, binding);
  return out;
}

}  // namespace marrow::cook
