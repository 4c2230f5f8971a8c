#include "cook/mesh/build_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "common/distinct.h"
#include "common/failure.h"
#include "common/parallel.h"
#include "common/retold.h"
#include "cook/geometry/build_geometry.h"
#include "cook/mesh/bind_meshes.h"
#include "cook/mesh/lod.h"
#include "cook/mesh/scene_scale.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "cook/scene/whole_steps.h"
#include "cook/skin/primitive_palette.h"

namespace marrow::cook {
namespace {

// A primitive bound to a skin, or to one joint when `skin` is kNone: done once, however many nodes draw it.
struct Bound {
  std::vector<Palette> palettes;  // a part; unused for one joint: each node has its own
  std::size_t doubled = 0;        // as BuiltMesh's
  std::uint32_t task = 0;
  int learnt = kNone;          // index into BuiltScene::learnt
  std::vector<BuiltLod> lods;  // their geometries are tasks
};
using BoundPrimitives = std::map<std::tuple<int, std::size_t, int>, Bound>;  // mesh, primitive, skin
using Levels = std::map<std::pair<int, int>, std::vector<MeshLevel>>;        // mesh, skin; without one kNone

// Hung rigidly: one joint, the nearest at or above the node.
Palette bind_to_node(const NearestJoint& nearest) {
  return {{static_cast<std::uint16_t>(nearest.joint)}, {to_affine(nearest.joint_from_node)}, {}, {}};
}

// What build_geometry() is to make, each once.
struct Task {
  const RawPrimitive* primitive = nullptr;
  std::vector<Binding> bindings;
  std::vector<GeometryPart> parts;  // none: the primitive is whole
  DeformerData deformers;           // of the full mesh alone
  std::size_t joint_count = 0;
  MeshGrid grid;
  bool is_lod = false;
};

// The palette entries of each part, out of the whole primitive's.
std::vector<std::vector<std::uint16_t>> entries_of_parts(const RawPrimitive& primitive, std::size_t number,
                                                         const RawSkin& skin, const SkinBinding& binding,
                                                         const std::vector<std::uint16_t>& entry_of) {
  std::vector<std::vector<std::uint16_t>> out;
  for (const PrimitivePart& part : parts_of(primitive, binding.part_of[number])) {
    std::vector<std::uint16_t>& entries = out.emplace_back();
    for (const std::uint32_t v : part.vertices)
      for (const std::uint32_t joint : palette_needs(binding, skin.joints.size(), binding.primitives[number][v]))
        entries.push_back(entry_of[joint]);
    tools::make_distinct(entries);
  }
  return out;
}

std::vector<GeometryPart> geometry_parts(const RawPrimitive& primitive, const std::vector<std::uint32_t>& part_of,
                                         const std::vector<std::vector<std::uint16_t>>& entries) {
  std::vector<GeometryPart> out;
  if (part_of.empty()) return out;
  for (PrimitivePart& part : parts_of(primitive, part_of))
    out.push_back({std::move(part.vertices), std::move(part.indices), entries[out.size()]});
  return out;
}

// How many vertices are in several parts, one counted for each part but the first.
std::size_t doubled_vertices(const std::vector<GeometryPart>& parts) {
  std::size_t all = 0;
  std::set<std::uint32_t> distinct;
  for (const GeometryPart& part : parts) {
    all += part.vertices.size();
    distinct.insert(part.vertices.begin(), part.vertices.end());
  }
  return all - distinct.size();
}

// What hangs on a node: each vertex on one joint.
Bound hang_primitive(const RawPrimitive& primitive, std::size_t number, const std::vector<MeshLevel>& levels, Task task,
                     std::vector<Task>& tasks) {
  Bound bound;
  task.joint_count = 1;
  const auto add = [&](const RawPrimitive& part) {
    task.primitive = &part;
    task.bindings.assign(part.positions.size(), {{0}, {1.0}, {}});
    tasks.push_back(task);
    task.is_lod = true;
    return static_cast<std::uint32_t>(tasks.size() - 1);
  };
  bound.task = add(primitive);
  for (const MeshLevel& level : levels)
    bound.lods.push_back({add(level.primitives[number]), level.rms_error_m, level.max_error_m});
  return bound;
}

// Adds what is to be built of one primitive, in full and at each level.
Bound bind_primitive(const RawPrimitive& primitive, std::size_t number, const RawSkin& skin, const SkinBinding& binding,
                     const std::vector<MeshLevel>& levels, const BuiltScene& built, const SceneScale& scale, Task task,
                     std::vector<Task>& tasks) {
  Bound bound;
  std::vector<std::uint16_t> entry_of;
  const Palette palette = make_palette(skin, binding, binding.primitives[number], built.joint_of_node, entry_of);
  task.grid.rest = scale.places(built.nearest[to_index(skin.joints.front())].skeleton, palette);
  std::vector<std::vector<std::uint16_t>> entries;
  if (binding.part_of[number].empty()) {
    bound.palettes.push_back(palette);
  } else {
    entries = entries_of_parts(primitive, number, skin, binding, entry_of);
    for (const std::vector<std::uint16_t>& part : entries) bound.palettes.push_back(some_of(palette, part));
  }
  task.deformers = deformer_data(binding, number, entry_of, palette.size());
  task.grid.residual_step = binding.residual_step_m;
  task.grid.residual_weight_step = binding.residual_weight_step;
  task.grid.residual_source = binding.residual_source;
  task.joint_count = palette.size();
  const auto add = [&](const RawPrimitive& part, const std::vector<BoundVertex>& vertices,
                       const std::vector<std::uint32_t>& part_of) {
    task.primitive = &part;
    task.bindings = bind_vertices(binding, vertices, entry_of);
    task.parts = geometry_parts(part, part_of, entries);
    tasks.push_back(task);
    task.is_lod = true;
    task.deformers = {};
    return static_cast<std::uint32_t>(tasks.size() - 1);
  };
  bound.task = add(primitive, binding.primitives[number], binding.part_of[number]);
  bound.doubled = doubled_vertices(tasks.back().parts);
  for (const MeshLevel& level : levels)
    bound.lods.push_back({add(level.primitives[number], level.vertices[number], level.part_of[number]),
                          level.rms_error_m, level.max_error_m});
  return bound;
}

// Once for all its primitives.
const std::vector<MeshLevel>& levels_of(const RawScene& scene, const RawMesh& mesh, int number, int skin,
                                        const SkinBinding* binding, const MeshOptions& options, const BuiltScene& built,
                                        Levels& levels, Notes& notes) {
  const auto [at, is_new] = levels.try_emplace({number, skin});
  if (is_new && !options.lod.empty())
    at->second = make_levels(mesh, skin == kNone ? nullptr : &scene.skins[static_cast<std::size_t>(skin)], binding,
                             built, options.lod, notes);
  return at->second;
}

// Geometries that differ, each once.
class Geometries {
 public:
  explicit Geometries(std::vector<BuiltGeometry>& all) : all_(all) {}
  std::uint32_t number_of(BuiltGeometry geometry) {
    const std::string_view bytes(reinterpret_cast<const char*>(geometry.section.data()), geometry.section.size());
    const auto [first, end] = by_hash_.equal_range(std::hash<std::string_view>()(bytes));
    for (auto i = first; i != end; ++i) {
      BuiltGeometry& other = all_[i->second];
      if (other.section.size() != bytes.size() || std::memcmp(other.section.data(), bytes.data(), bytes.size()) != 0)
        continue;
      other.error = worst_of(other.error, geometry.error);  // it may stand otherwise, or be rounded to the same
      return i->second;
    }
    const auto number = static_cast<std::uint32_t>(all_.size());
    by_hash_.emplace(std::hash<std::string_view>()(bytes), number);
    all_.push_back(std::move(geometry));
    return number;
  }

 private:
  std::vector<BuiltGeometry>& all_;
  std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;
};

// The parts of one task.
std::vector<BuiltGeometry> build_task(const std::string& source, const Task& task, MeshOptions options) {
  options.keep_vertex_order = options.keep_vertex_order && !task.is_lod;
  const auto build = [&]() -> std::vector<BuiltGeometry> {
    if (!task.parts.empty())
      return build_geometries(*task.primitive, task.bindings, task.joint_count, task.parts, task.grid, options,
                              task.deformers);
    return {build_geometry(*task.primitive, task.bindings, task.joint_count, task.grid, options, task.deformers)};
  };
  return tools::retold<tools::Failure>(build, [&](const tools::Failure& failure) {
    return tools::Failure(failure.code(), source, task.primitive->pointer, failure.rule(), failure.advice());
  });
}

// On all cores; returns for each task which geometries its parts have become, of those that differ. So many at a time,
// for what is the same need not be kept.
std::vector<std::vector<std::uint32_t>> build_tasks(const std::string& source, const std::vector<Task>& tasks,
                                                    const MeshOptions& options,
                                                    std::vector<BuiltGeometry>& geometries) {
  constexpr std::size_t kAtATime = 1024;
  Geometries distinct(geometries);
  std::vector<std::vector<std::uint32_t>> numbers;
  for (std::size_t first = 0; first < tasks.size(); first += kAtATime) {
    std::vector<std::vector<BuiltGeometry>> built(std::min(kAtATime, tasks.size() - first));
    tools::for_each_in_parallel(built.size(),
                                [&](std::size_t i) { built[i] = build_task(source, tasks[first + i], options); });
    for (std::vector<BuiltGeometry>& parts : built) {
      std::vector<std::uint32_t>& number = numbers.emplace_back();
      for (BuiltGeometry& geometry : parts) number.push_back(distinct.number_of(std::move(geometry)));
    }
  }
  return numbers;
}

// Helpers' centres to 2^-13 of the largest coordinate, two bytes each in a packed file.
void round_centres(BuiltMesh& mesh) {
  float longest = 0;
  for (const float c : mesh.helper_centres) longest = std::max(longest, std::abs(c));
  mesh.centre_exponent = exponent_for(longest, (1 << 13) - 1);
  for (float& c : mesh.helper_centres) c = whole_steps(c, mesh.centre_exponent);
}

BuiltMesh build_mesh(const RawScene& scene, const RawInstance& instance, const RawPrimitive& primitive,
                     const Bound& bound, std::uint32_t part, int skin, int subdivide, const BuiltScene& built,
                     const SceneScale& scale) {
  // All joints of a skin are of one skeleton.
  const int follows = skin == kNone ? instance.node : scene.skins[static_cast<std::size_t>(skin)].joints.front();
  const NearestJoint& nearest = built.nearest[static_cast<std::size_t>(follows)];
  const Palette palette = skin == kNone ? bind_to_node(nearest) : bound.palettes[part];
  BuiltMesh mesh;
  mesh.skeleton = static_cast<std::uint32_t>(nearest.skeleton);
  mesh.name = scene.meshes[static_cast<std::size_t>(instance.mesh)].name;
  if (mesh.name.empty()) mesh.name = scene.nodes[static_cast<std::size_t>(instance.node)].name;
  mesh.geometry = bound.task;
  mesh.part = part;
  mesh.parts = static_cast<std::uint32_t>(std::max<std::size_t>(1, bound.palettes.size()));
  mesh.doubled = bound.doubled;
  mesh.learnt = bound.learnt;
  mesh.joints = palette.joints;
  mesh.inverse_bind = palette.inverse_bind;
  mesh.helpers = palette.helpers;
  mesh.helper_centres = palette.helper_centres;
  round_centres(mesh);
  mesh.scene_scale = scale.of(mesh.skeleton, mesh.joints, mesh.inverse_bind);
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

// Everything that is drawn, each primitive bound once.
struct Drawn {
  std::vector<BuiltMesh> meshes;  // their geometries are tasks
  std::vector<Task> tasks;        // of primitives in BoundMeshes, the scene and `levels`
  Levels levels;
};

Drawn draw_meshes(const RawScene& scene, const BuiltScene& built, const BoundMeshes& bound_meshes,
                  const MeshOptions& options, Notes& notes) {
  Drawn out;
  BoundPrimitives bound;
  const SceneScale scale(built.skeletons, scene);
  std::map<int, MeshGrid> grids;
  for (const RawInstance& instance : scene.instances) {
    const RawMesh& source = bound_meshes.mesh(scene, instance.mesh);
    if (!grids.contains(instance.mesh))
      grids[instance.mesh] = mesh_grid(source, scale.of(scene, built, instance.mesh), options);
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      const RawPrimitive& primitive = source.primitives[i];
      const int skin = is_skinned(instance, primitive) ? instance.skin : kNone;
      const auto [found, is_new] = bound.try_emplace({instance.mesh, i, skin});
      if (is_new) {
        Task task;
        task.grid = grids[instance.mesh];
        const SkinBinding* const binding = skin == kNone ? nullptr : &bound_meshes.bindings.at({instance.mesh, skin});
        const std::vector<MeshLevel>& lods =
            levels_of(scene, source, instance.mesh, skin, binding, options, built, out.levels, notes);
        found->second = binding == nullptr ? hang_primitive(primitive, i, lods, std::move(task), out.tasks)
                                           : bind_primitive(primitive, i, scene.skins[static_cast<std::size_t>(skin)],
                                                            *binding, lods, built, scale, std::move(task), out.tasks);
        found->second.learnt = binding == nullptr ? kNone : binding->report;
      }
      const std::size_t parts = std::max<std::size_t>(1, found->second.palettes.size());
      for (std::uint32_t part = 0; part < parts; ++part)
        out.meshes.push_back(
            build_mesh(scene, instance, primitive, found->second, part, skin, options.subdivide, built, scale));
    }
  }
  return out;
}

// Tells meshes apart that differ in their vertices or in what these hang on.
std::string key_of(const BuiltMesh& mesh) {
  std::string key;
  const auto add = [&](const auto* first, std::size_t count) {
    key.append(reinterpret_cast<const char*>(first), count * sizeof *first);
  };
  add(&mesh.geometry, 1);
  add(&mesh.skeleton, 1);
  add(mesh.joints.data(), mesh.joints.size());
  add(mesh.inverse_bind.data(), mesh.inverse_bind.size());
  add(mesh.helpers.data(), mesh.helpers.size());
  add(mesh.helper_centres.data(), mesh.helper_centres.size());
  return key;
}

}  // namespace

std::vector<Mesh> full_meshes(const BuiltMeshes& built) {
  std::vector<Mesh> out;
  for (const BuiltMesh& mesh : built.meshes) out.push_back(view(mesh, built.geometries[mesh.geometry]));
  return out;
}

BuiltMeshes build_meshes(const RawScene& scene, const BuiltScene& built, const MeshOptions& options,
                         const LearnOptions& learn, Notes& notes) {
  BoundMeshes bound = bind_meshes(scene, built, options, learn, notes);
  Drawn drawn = draw_meshes(scene, built, bound, options, notes);
  BuiltMeshes out{{}, std::move(bound.learnt), std::move(drawn.meshes)};
  const std::vector<std::vector<std::uint32_t>> geometries =
      build_tasks(scene.source, drawn.tasks, options, out.geometries);
  for (BuiltMesh& mesh : out.meshes) {
    mesh.geometry = geometries[mesh.geometry][mesh.part];
    for (BuiltLod& lod : mesh.lods) lod.geometry = geometries[lod.geometry][mesh.part];
    mesh.targets.resize(out.geometries[mesh.geometry].target_count);
  }
  return out;
}

std::vector<Mesh> distinct_views(const BuiltMeshes& built) {
  std::vector<Mesh> out;
  std::unordered_set<std::string> seen;
  for (const BuiltMesh& mesh : built.meshes) {
    if (!seen.insert(key_of(mesh)).second) continue;
    out.push_back(view(mesh, built.geometries[mesh.geometry]));
    for (const BuiltLod& lod : mesh.lods) out.push_back(view(mesh, built.geometries[lod.geometry]));
  }
  return out;
}

}  // namespace marrow::cook
