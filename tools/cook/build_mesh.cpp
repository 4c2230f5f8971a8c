// Which geometries there are, and which joints each mesh binds them to.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "common/failure.h"
#include "common/parallel.h"
#include "cook/build.h"
#include "cook/deform_source.h"
#include "cook/learn_deformers.h"
#include "cook/skin_binding.h"
#include "cook/subdivide.h"

namespace marrow::cook {
namespace {

// What a primitive's vertices are bound to.
struct Palette {
  std::vector<std::uint16_t> joints;
  std::vector<Affine> inverse_bind;
  std::vector<HalfJoint> half_joints;
};

// A primitive bound to a skin, or to one joint when `skin` is kNone: done once, however many nodes draw it.
struct Bound {
  Palette palette;  // unused for one joint: each node has its own
  std::uint32_t task = 0;
  int learnt = kNone;          // index into BuiltScene::learnt
  std::vector<BuiltLod> lods;  // their geometries are tasks
};
using BoundPrimitives = std::map<std::tuple<int, std::size_t, int>, Bound>;  // mesh, primitive, skin
using SkinBindings = std::map<std::pair<int, int>, SkinBinding>;             // mesh, skin
using Levels = std::map<std::pair<int, int>, std::vector<MeshLevel>>;        // mesh, skin; without one kNone

// The joints that vertices and their deformers use, and those that half-joints stand between; entries in the skin's
// order.
Palette make_palette(const RawSkin& skin, const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                     const std::vector<int>& joint_of_node, std::vector<std::uint16_t>& entry_of) {
  const std::size_t joints = skin.joints.size();
  entry_of.assign(joints + binding.half_joints.size(), 0);
  for (const std::uint32_t j : joints_of_deformers(binding.deformers, vertices)) entry_of[j] = 1;
  for (const BoundVertex& vertex : vertices)
    for (const BoundInfluence& i : vertex) entry_of[i.joint] = 1;
  for (std::size_t h = 0; h < binding.half_joints.size(); ++h)
    if (entry_of[joints + h] != 0) entry_of[binding.half_joints[h].parent] = entry_of[binding.half_joints[h].joint] = 1;
  Palette out;
  for (std::size_t j = 0; j < joints; ++j) {
    if (entry_of[j] == 0) continue;
    entry_of[j] = static_cast<std::uint16_t>(out.joints.size());
    out.joints.push_back(static_cast<std::uint16_t>(joint_of_node[static_cast<std::size_t>(skin.joints[j])]));
    out.inverse_bind.push_back(to_affine(skin.inverse_bind[j]));
  }
  for (std::size_t h = 0; h < binding.half_joints.size(); ++h) {
    if (entry_of[joints + h] == 0) continue;
    const deform::HalfJoint& half = binding.half_joints[h];
    entry_of[joints + h] = static_cast<std::uint16_t>(out.joints.size() + out.half_joints.size());
    out.half_joints.push_back({entry_of[half.parent], entry_of[half.joint], static_cast<float>(half.share)});
  }
  return out;
}

std::vector<Binding> bind_vertices(const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                                   const std::vector<std::uint16_t>& entry_of) {
  std::vector<Binding> out;
  for (const BoundVertex& vertex : vertices) {
    Binding b;
    for (const BoundInfluence& i : vertex) {
      b.set.push_back(entry_of[i.joint]);
      b.weights.push_back(i.weight);
      if (binding.residual_step_m > 0) b.residual.push_back(i.residual);
    }
    out.push_back(std::move(b));
  }
  return out;
}

// Hung rigidly: one joint, the nearest at or above the node.
Palette bind_to_node(const NearestJoint& nearest) {
  return {{static_cast<std::uint16_t>(nearest.joint)}, {to_affine(nearest.joint_from_node)}, {}};
}

// One grid for all primitives of a mesh, so that where they touch they still do.
MeshGrid mesh_grid(const RawMesh& mesh, const CookOptions& options) {
  if (options.mesh_codec == MeshCodec::none) return {};
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
  // Half a step along each axis is the farthest.
  double step = options.position_error * (options.position_error_is_share ? side : 1.0) * 2 / std::sqrt(3.0);
  if (step <= 0) step = side / kSteps;
  constexpr double kMostSteps = (1 << packed::kMaxValueBits) - 1;
  step = std::max(step, side / kMostSteps);
  return {low, step > 0 ? step : 1.0};
}

// What build_geometry() is to make, each once.
struct Task {
  const RawPrimitive* primitive = nullptr;
  std::vector<Binding> bindings;
  DeformerData deformers;  // of the full mesh alone
  std::size_t joint_count = 0;
  MeshGrid grid;
  bool is_lod = false;
};

// Adds what is to be built of one primitive, in full and at each level. skin, binding: null if it hangs on a node.
Bound bind_primitive(const RawPrimitive& primitive, std::size_t number, const RawSkin* skin, const SkinBinding* binding,
                     const std::vector<MeshLevel>& levels, const std::vector<int>& joint_of_node, Task task,
                     std::vector<Task>& tasks) {
  Bound bound;
  std::vector<std::uint16_t> entry_of;
  if (skin != nullptr) {
    bound.palette = make_palette(*skin, *binding, binding->primitives[number], joint_of_node, entry_of);
    task.deformers =
        deformer_data(*binding, number, entry_of, bound.palette.joints.size() + bound.palette.half_joints.size());
    task.grid.residual_step = binding->residual_step_m;
    task.grid.residual_weight_step = binding->residual_weight_step;
  }
  task.joint_count = skin != nullptr ? bound.palette.joints.size() + bound.palette.half_joints.size() : 1;
  const auto add = [&](const RawPrimitive& part, const std::vector<BoundVertex>* vertices) {
    task.primitive = &part;
    task.bindings = skin != nullptr ? bind_vertices(*binding, *vertices, entry_of)
                                    : std::vector<Binding>(part.positions.size(), {{0}, {1.0}, {}});
    tasks.push_back(task);
    task.is_lod = true;
    task.deformers = {};
    return static_cast<std::uint32_t>(tasks.size() - 1);
  };
  bound.task = add(primitive, skin != nullptr ? &binding->primitives[number] : nullptr);
  for (const MeshLevel& level : levels)
    bound.lods.push_back({add(level.primitives[number], skin != nullptr ? &level.vertices[number] : nullptr),
                          level.rms_error_m, level.max_error_m});
  return bound;
}

// Bound, and learnt from its poses, once for all its primitives.
void bind_mesh(RawScene& scene, int mesh, int skin, const CookOptions& options, SkinBindings& bindings,
               BuiltScene& out) {
  const auto [at, is_new] = bindings.try_emplace({mesh, skin});
  if (is_new) {
    const RawMesh& source = scene.meshes[static_cast<std::size_t>(mesh)];
    const RawSkin& onto = scene.skins[static_cast<std::size_t>(skin)];
    at->second = bind_to_skin(scene, source);
    out.learnt.push_back(learn_binding(scene, source, onto, out, options.learn, at->second));
    learn_deformers(scene, source, onto, out, options, mesh_grid(source, options), at->second, out.learnt.back());
    at->second.report = static_cast<int>(out.learnt.size()) - 1;
  }
}

bool is_skinned(const RawInstance& instance, const RawPrimitive& primitive) {
  return instance.skin != kNone && !primitive.influences.empty();
}

SkinBindings bind_meshes(RawScene& scene, const CookOptions& options, BuiltScene& out) {
  SkinBindings bindings;
  for (const RawInstance& instance : scene.instances)
    for (const RawPrimitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
      if (is_skinned(instance, primitive)) bind_mesh(scene, instance.mesh, instance.skin, options, bindings, out);
  return bindings;
}

// What is drawn, for all that follows.
void subdivide_meshes(RawScene& scene, int steps, const BuiltScene& built, SkinBindings& bindings) {
  std::set<int> drawn;
  for (const RawInstance& instance : scene.instances) drawn.insert(instance.mesh);
  for (const int number : drawn) {
    RawMesh& mesh = scene.meshes[static_cast<std::size_t>(number)];
    std::vector<MovedBy> skins;
    for (auto& bound : bindings) {
      if (bound.first.first != number) continue;
      SkinBinding& binding = bound.second;
      const RawSkin& skin = scene.skins[static_cast<std::size_t>(bound.first.second)];
      skins.push_back({&binding, [&mesh, &skin, &binding, &built] {
                         return poses_of_clips(deform_source(mesh, skin, binding, built), binding, built);
                       }});
    }
    const std::size_t cut = subdivide_mesh(mesh, skins, steps);
    if (cut > 0)
      scene.warnings.push_back({mesh.primitives.front().pointer, "influences-dropped",
                                std::to_string(cut) +
                                    " points of the finer mesh would follow more than 8 joints; they get the closest "
                                    "that 8 can do"});
  }
}

// Once for all its primitives.
const std::vector<MeshLevel>& levels_of(RawScene& scene, int mesh, int skin, const SkinBinding* binding,
                                        const CookOptions& options, const BuiltScene& built, Levels& levels) {
  const auto [at, is_new] = levels.try_emplace({mesh, skin});
  if (is_new && !options.lod.empty())
    at->second = make_levels(scene, scene.meshes[static_cast<std::size_t>(mesh)],
                             skin == kNone ? nullptr : &scene.skins[static_cast<std::size_t>(skin)], binding, built,
                             options.lod);
  return at->second;
}

bool same(const BuiltGeometry& a, const BuiltGeometry& b) {
  return a.section.size() == b.section.size() && std::memcmp(a.section.data(), b.section.data(), a.section.size()) == 0;
}

// On all cores; returns for each task which geometry it has become, of those that differ.
std::vector<std::uint32_t> build_geometries(const std::string& source, const std::vector<Task>& tasks,
                                            const CookOptions& options, BuiltScene& out) {
  std::vector<BuiltGeometry> built(tasks.size());
  tools::for_each_in_parallel(tasks.size(), [&](std::size_t i) {
    const Task& task = tasks[i];
    try {
      CookOptions with = options;
      with.keep_vertex_order = options.keep_vertex_order && !task.is_lod;
      built[i] = build_geometry(*task.primitive, task.bindings, task.joint_count, task.grid, with, task.deformers);
    } catch (const tools::Failure& failure) {
      throw tools::Failure(failure.code(), source, task.primitive->pointer, failure.rule(), failure.advice());
    }
  });
  std::vector<std::uint32_t> number;
  for (BuiltGeometry& geometry : built) {
    const auto twin = std::find_if(out.geometries.begin(), out.geometries.end(),
                                   [&](const BuiltGeometry& g) { return same(g, geometry); });
    number.push_back(static_cast<std::uint32_t>(twin - out.geometries.begin()));
    if (twin == out.geometries.end()) out.geometries.push_back(std::move(geometry));
  }
  return number;
}

BuiltMesh build_mesh(const RawScene& scene, const RawInstance& instance, const RawPrimitive& primitive,
                     const Bound& bound, int skin, int subdivide, const BuiltScene& built) {
  // All joints of a skin are of one skeleton.
  const int follows = skin == kNone ? instance.node : scene.skins[static_cast<std::size_t>(skin)].joints.front();
  const NearestJoint& nearest = built.nearest[static_cast<std::size_t>(follows)];
  const Palette palette = skin == kNone ? bind_to_node(nearest) : bound.palette;
  BuiltMesh mesh;
  mesh.skeleton = static_cast<std::uint32_t>(nearest.skeleton);
  mesh.name = scene.meshes[static_cast<std::size_t>(instance.mesh)].name;
  if (mesh.name.empty()) mesh.name = scene.nodes[static_cast<std::size_t>(instance.node)].name;
  mesh.geometry = bound.task;
  mesh.learnt = bound.learnt;
  mesh.joints = palette.joints;
  mesh.inverse_bind = palette.inverse_bind;
  mesh.half_joints = palette.half_joints;
  mesh.lods = bound.lods;
  if (subdivide > 0) mesh.source_triangles = primitive.indices.size() / 3 >> (2 * subdivide);
  mesh.targets = instance.weights;
  mesh.raw_material = primitive.material;
  if (primitive.material != kNone) {
    const RawMaterial& material = scene.materials[static_cast<std::size_t>(primitive.material)];
    mesh.material = material.name;
    mesh.double_sided = material.double_sided;
    for (int c = 0; c < 4; ++c) mesh.base_colour[c] = material.base_colour[c];
  }
  return mesh;
}

}  // namespace

void build_meshes(RawScene& scene, const CookOptions& options, BuiltScene& out) {
  SkinBindings bindings = bind_meshes(scene, options, out);
  if (options.subdivide > 0) subdivide_meshes(scene, options.subdivide, out, bindings);
  BoundPrimitives bound;
  Levels levels;
  std::vector<Task> tasks;
  for (const RawInstance& instance : scene.instances) {
    RawMesh& source = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      RawPrimitive& primitive = source.primitives[i];
      const int skin = is_skinned(instance, primitive) ? instance.skin : kNone;
      const auto key = std::make_tuple(instance.mesh, i, skin);
      auto found = bound.find(key);
      if (found == bound.end()) {
        Task task;
        task.grid = mesh_grid(source, options);
        const SkinBinding* const binding = skin == kNone ? nullptr : &bindings.at({instance.mesh, skin});
        const std::vector<MeshLevel>& lods = levels_of(scene, instance.mesh, skin, binding, options, out, levels);
        Bound fresh =
            bind_primitive(primitive, i, skin == kNone ? nullptr : &scene.skins[static_cast<std::size_t>(skin)],
                           binding, lods, out.joint_of_node, std::move(task), tasks);
        fresh.learnt = binding == nullptr ? kNone : binding->report;
        found = bound.emplace(key, std::move(fresh)).first;
      }
      out.meshes.push_back(build_mesh(scene, instance, primitive, found->second, skin, options.subdivide, out));
    }
  }
  const std::vector<std::uint32_t> geometries = build_geometries(scene.source, tasks, options, out);
  for (BuiltMesh& mesh : out.meshes) {
    mesh.geometry = geometries[mesh.geometry];
    for (BuiltLod& lod : mesh.lods) lod.geometry = geometries[lod.geometry];
    mesh.targets.resize(out.geometries[mesh.geometry].target_count);
  }
}

}  // namespace marrow::cook
