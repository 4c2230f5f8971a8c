// Which geometries there are, and which joints each mesh binds them to.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include "common/failure.h"
#include "common/parallel.h"
#include "cook/build.h"

namespace marrow::cook {
namespace {

// What a primitive's vertices are bound to.
struct Palette {
  std::vector<std::uint16_t> joints;
  std::vector<Affine> inverse_bind;
};

// A primitive bound to a skin, or to one joint when `skin` is kNone: done once, however many nodes draw it.
struct Bound {
  Palette palette;  // unused for one joint: each node has its own
  std::uint32_t task = 0;
};
using BoundPrimitives = std::map<std::tuple<int, std::size_t, int>, Bound>;  // mesh, primitive, skin

void warn(RawScene& scene, const std::string& pointer, const char* rule, const std::string& text) {
  scene.warnings.push_back({pointer, rule, text});
}

// Merges what names a joint twice, drops zeros, keeps the largest, in double precision.
std::vector<std::pair<std::uint32_t, double>> largest_influences(const std::vector<RawInfluence>& raw, std::size_t most,
                                                                 std::size_t& dropped) {
  std::map<std::uint32_t, double> merged;
  for (const RawInfluence& i : raw)
    if (i.weight > 0) merged[i.joint] += static_cast<double>(i.weight);
  std::vector<std::pair<std::uint32_t, double>> kept(merged.begin(), merged.end());
  if (kept.size() > most) {
    std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    kept.resize(most);
    std::sort(kept.begin(), kept.end());
    ++dropped;
  }
  double sum = 0;
  for (const auto& [joint, weight] : kept) sum += weight;
  for (auto& [joint, weight] : kept) weight /= sum;
  if (kept.empty()) kept.emplace_back(0u, 1.0);
  return kept;
}

Palette bind_to_skin(RawScene& scene, const RawPrimitive& primitive, const RawSkin& skin,
                     const std::vector<int>& joint_of_node, std::vector<Binding>& bindings) {
  Palette out;
  std::size_t dropped = 0, unbound = 0;
  std::vector<std::vector<std::pair<std::uint32_t, double>>> influences;
  std::vector<std::uint16_t> entry_of_joint(skin.joints.size(), 0);
  for (const std::vector<RawInfluence>& raw : primitive.influences) {
    unbound += std::none_of(raw.begin(), raw.end(), [](const RawInfluence& i) { return i.weight > 0; });
    influences.push_back(largest_influences(raw, kMaxInfluences, dropped));
    for (const auto& [joint, weight] : influences.back()) entry_of_joint[joint] = 1;
  }
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    if (entry_of_joint[j] == 0) continue;
    entry_of_joint[j] = static_cast<std::uint16_t>(out.joints.size());
    out.joints.push_back(static_cast<std::uint16_t>(joint_of_node[static_cast<std::size_t>(skin.joints[j])]));
    out.inverse_bind.push_back(to_affine(skin.inverse_bind[j]));
  }
  for (const auto& vertex : influences) {
    Binding binding;
    for (const auto& [joint, weight] : vertex) {
      binding.set.push_back(entry_of_joint[joint]);
      binding.weights.push_back(weight);
    }
    bindings.push_back(std::move(binding));
  }
  if (dropped > 0)
    warn(scene, primitive.pointer, "influences-dropped",
         std::to_string(dropped) + " vertices had more than 8 influences; the 8 largest are kept and renormalised");
  if (unbound > 0)
    warn(scene, primitive.pointer, "weights-zero",
         std::to_string(unbound) + " vertices had no weight above 0; they follow the skin's first joint");
  return out;
}

// Hung rigidly: one joint, the nearest at or above the node.
Palette bind_to_node(const NearestJoint& nearest) {
  return {{static_cast<std::uint16_t>(nearest.joint)}, {to_affine(nearest.joint_from_node)}};
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
  const RawPrimitive* primitive;
  std::vector<Binding> bindings;
  std::size_t joint_count;
  MeshGrid grid;
};

Bound bind_primitive(RawScene& scene, RawPrimitive& primitive, int skin, const std::vector<int>& joint_of_node,
                     Task& task) {
  Bound bound;
  if (skin != kNone) {
    bound.palette =
        bind_to_skin(scene, primitive, scene.skins[static_cast<std::size_t>(skin)], joint_of_node, task.bindings);
  } else {
    task.bindings.assign(primitive.positions.size(), {{0}, {1.0}});
  }
  task.primitive = &primitive;
  task.joint_count = skin != kNone ? bound.palette.joints.size() : 1;
  return bound;
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
      built[i] = build_geometry(*task.primitive, task.bindings, task.joint_count, task.grid, options);
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
                     const Bound& bound, int skin, const BuiltScene& built) {
  // All joints of a skin are of one skeleton.
  const int follows = skin == kNone ? instance.node : scene.skins[static_cast<std::size_t>(skin)].joints.front();
  const NearestJoint& nearest = built.nearest[static_cast<std::size_t>(follows)];
  const Palette palette = skin == kNone ? bind_to_node(nearest) : bound.palette;
  BuiltMesh mesh;
  mesh.skeleton = static_cast<std::uint32_t>(nearest.skeleton);
  mesh.name = scene.meshes[static_cast<std::size_t>(instance.mesh)].name;
  if (mesh.name.empty()) mesh.name = scene.nodes[static_cast<std::size_t>(instance.node)].name;
  mesh.geometry = bound.task;
  mesh.joints = palette.joints;
  mesh.inverse_bind = palette.inverse_bind;
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
  BoundPrimitives bound;
  std::vector<Task> tasks;
  for (const RawInstance& instance : scene.instances) {
    RawMesh& source = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      RawPrimitive& primitive = source.primitives[i];
      const bool skinned = instance.skin != kNone && !primitive.influences.empty();
      const int skin = skinned ? instance.skin : kNone;
      const auto key = std::make_tuple(instance.mesh, i, skin);
      auto found = bound.find(key);
      if (found == bound.end()) {
        Task task;
        Bound fresh = bind_primitive(scene, primitive, skin, out.joint_of_node, task);
        fresh.task = static_cast<std::uint32_t>(tasks.size());
        task.grid = mesh_grid(source, options);
        tasks.push_back(std::move(task));
        found = bound.emplace(key, std::move(fresh)).first;
      }
      out.meshes.push_back(build_mesh(scene, instance, primitive, found->second, skin, out));
    }
  }
  const std::vector<std::uint32_t> geometries = build_geometries(scene.source, tasks, options, out);
  for (BuiltMesh& mesh : out.meshes) {
    mesh.geometry = geometries[mesh.geometry];
    mesh.targets.resize(out.geometries[mesh.geometry].target_count);
  }
}

}  // namespace marrow::cook
