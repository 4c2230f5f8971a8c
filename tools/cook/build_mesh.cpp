// Vertices become blocks: grouped by the joints they depend on, four at a time, one lane a vertex.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <tuple>

#include "common/failure.h"
#include "cook/build.h"
#include "cook/normals.h"

namespace marrow::cook {
namespace {

// A vertex's joints, as palette entries in ascending order, with weights that sum to one.
struct Binding {
  std::vector<std::uint16_t> set;
  std::vector<float> weights;  // one fewer than `set`: the last is what they leave
};

// What a primitive's vertices are bound to.
struct Palette {
  std::vector<std::uint16_t> joints;
  std::vector<Affine> inverse_bind;
};

// A primitive bound to a skin, or to one joint when `skin` is kNone: done once, however many nodes draw it.
struct Bound {
  Palette palette;  // unused for one joint: each node has its own
  std::uint32_t geometry = 0;
  std::uint32_t influences = 0;
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

Palette bind_to_skin(RawScene& scene, const RawPrimitive& primitive, const RawSkin& skin, const BuiltSkeleton& skeleton,
                     std::vector<Binding>& bindings) {
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
    out.joints.push_back(static_cast<std::uint16_t>(skeleton.joint_of_node[static_cast<std::size_t>(skin.joints[j])]));
    out.inverse_bind.push_back(to_affine(skin.inverse_bind[j]));
  }
  for (const auto& vertex : influences) {
    Binding binding;
    for (const auto& [joint, weight] : vertex) {
      binding.set.push_back(entry_of_joint[joint]);
      binding.weights.push_back(static_cast<float>(weight));
    }
    binding.weights.pop_back();
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
Palette bind_to_node(int node, const BuiltSkeleton& skeleton) {
  const NearestJoint& nearest = skeleton.nearest[static_cast<std::size_t>(node)];
  return {{static_cast<std::uint16_t>(nearest.joint)}, {to_affine(nearest.joint_from_node)}};
}

// Where each vertex goes: grouped by joint set (fewest influences first), within a group by first use, so that vertices
// of neighbouring triangles stay neighbours.
struct Arrangement {
  std::vector<std::uint32_t> slot_of_vertex;
  std::vector<std::uint32_t> vertex_of_slot;  // padding repeats the run's last vertex
  std::vector<Run> runs;
  std::vector<std::uint16_t> sets;
};

Arrangement arrange(const RawPrimitive& primitive, const std::vector<Binding>& bindings) {
  const std::size_t count = bindings.size();
  std::vector<std::uint32_t> first_use(count, UINT32_MAX);
  std::uint32_t uses = 0;
  for (const std::uint32_t i : primitive.indices) first_use[i] = std::min(first_use[i], uses++);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto& sa = bindings[a].set;
    const auto& sb = bindings[b].set;
    if (sa.size() != sb.size()) return sa.size() < sb.size();
    if (sa != sb) return sa < sb;
    if (first_use[a] != first_use[b]) return first_use[a] < first_use[b];
    return a < b;
  });
  Arrangement out;
  out.slot_of_vertex.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& set = bindings[order[i]].set;
    if (i == 0 || set != bindings[order[i - 1]].set) {
      while (out.vertex_of_slot.size() % 4 != 0) out.vertex_of_slot.push_back(order[i - 1]);
      out.runs.push_back({0, static_cast<std::uint32_t>(set.size())});
      out.sets.insert(out.sets.end(), set.begin(), set.end());
    }
    ++out.runs.back().vertex_count;
    out.slot_of_vertex[order[i]] = static_cast<std::uint32_t>(out.vertex_of_slot.size());
    out.vertex_of_slot.push_back(order[i]);
  }
  while (out.vertex_of_slot.size() % 4 != 0) out.vertex_of_slot.push_back(order.back());
  return out;
}

// Appends one component of four vertices.
template <class Component>
void push_lanes(std::vector<float>& out, const std::uint32_t* vertices, Component component) {
  for (int lane = 0; lane < 4; ++lane) out.push_back(component(vertices[lane]));
}

void write_blocks(const RawPrimitive& p, const std::vector<Binding>& bindings, const Arrangement& a,
                  BuiltGeometry& out) {
  std::size_t block = 0;
  for (const Run& run : a.runs) {
    for (std::uint32_t i = 0; i < run.vertex_count; i += 4, ++block) {
      const std::uint32_t* const v = &a.vertex_of_slot[block * 4];
      for (int c = 0; c < 3; ++c) push_lanes(out.skin, v, [&](std::uint32_t n) { return p.positions[n][c]; });
      for (std::uint32_t j = 0; j + 1 < run.influences; ++j)
        push_lanes(out.skin, v, [&](std::uint32_t n) { return bindings[n].weights[j]; });
      for (int c = 0; c < 3 && !p.normals.empty(); ++c)
        push_lanes(out.normals, v, [&](std::uint32_t n) { return p.normals[n][c]; });
      for (int c = 0; c < 4 && !p.tangents.empty(); ++c)
        push_lanes(out.tangents, v, [&](std::uint32_t n) { return p.tangents[n][c]; });
    }
    out.header.influence_blocks += (run.vertex_count + 3) / 4 * run.influences;
  }
  for (const std::uint32_t v : a.vertex_of_slot) {
    if (!p.uvs.empty()) out.uvs.insert(out.uvs.end(), {p.uvs[v].x, p.uvs[v].y});
    for (int c = 0; c < 4 && !p.colours.empty(); ++c)
      out.colours.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(p.colours[v][c], 0.0f, 1.0f) * 255.0f)));
  }
}

BuiltGeometry build_geometry(const RawPrimitive& p, const std::vector<Binding>& bindings, std::size_t joint_count,
                             const CookOptions& options) {
  const Arrangement a = arrange(p, bindings);
  BuiltGeometry out;
  write_blocks(p, bindings, a, out);
  out.runs = a.runs;
  out.sets = a.sets;
  for (const std::uint32_t i : p.indices) out.indices.push_back(a.slot_of_vertex[i]);
  if (options.keep_vertex_order) out.source_slots = a.slot_of_vertex;

  format::GeometryHeader& h = out.header;
  h.flags = (p.normals.empty() ? 0u : format::kHasNormals) | (p.tangents.empty() ? 0u : format::kHasTangents) |
            (p.uvs.empty() ? 0u : format::kHasUvs) | (p.colours.empty() ? 0u : format::kHasColours) |
            (out.source_slots.empty() ? 0u : format::kHasSourceSlots);
  h.vertex_count = static_cast<std::uint32_t>(p.positions.size());
  h.block_count = static_cast<std::uint32_t>(a.vertex_of_slot.size() / 4);
  h.run_count = static_cast<std::uint32_t>(out.runs.size());
  h.set_count = static_cast<std::uint32_t>(out.sets.size());
  h.joint_count = static_cast<std::uint32_t>(joint_count);
  h.index_count = static_cast<std::uint32_t>(out.indices.size());
  h.source_vertex_count = static_cast<std::uint32_t>(out.source_slots.size());
  glm::vec3 low = p.positions.front(), high = low;
  for (const glm::vec3& v : p.positions) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  for (int c = 0; c < 3; ++c) {
    h.box_min[c] = low[c];
    h.box_max[c] = high[c];
  }
  return out;
}

bool same(const BuiltGeometry& a, const BuiltGeometry& b) {
  return std::memcmp(&a.header, &b.header, sizeof a.header) == 0 && a.skin == b.skin && a.normals == b.normals &&
         a.tangents == b.tangents && a.uvs == b.uvs && a.colours == b.colours && a.indices == b.indices &&
         a.sets == b.sets && a.source_slots == b.source_slots &&
         std::equal(a.runs.begin(), a.runs.end(), b.runs.begin(), b.runs.end(), [](const Run& x, const Run& y) {
           return x.vertex_count == y.vertex_count && x.influences == y.influences;
         });
}

Bound bind_primitive(RawScene& scene, RawPrimitive& primitive, int skin, const CookOptions& options, BuiltScene& out) {
  if (primitive.normals.empty()) {
    generate_normals(primitive);
    warn(scene, primitive.pointer, "normals-generated", "the file has no normals; smooth ones are computed");
  }
  Bound bound;
  std::vector<Binding> bindings;
  if (skin != kNone) {
    bound.palette = bind_to_skin(scene, primitive, scene.skins[static_cast<std::size_t>(skin)], out.skeleton, bindings);
  } else {
    bindings.assign(primitive.positions.size(), {{0}, {}});
  }
  const std::size_t joint_count = skin != kNone ? bound.palette.joints.size() : 1;
  BuiltGeometry geometry = build_geometry(primitive, bindings, joint_count, options);
  for (const Run& run : geometry.runs) bound.influences = std::max(bound.influences, run.influences);
  const auto twin = std::find_if(out.geometries.begin(), out.geometries.end(),
                                 [&](const BuiltGeometry& g) { return same(g, geometry); });
  bound.geometry = static_cast<std::uint32_t>(twin - out.geometries.begin());
  if (twin == out.geometries.end()) out.geometries.push_back(std::move(geometry));
  return bound;
}

BuiltMesh build_mesh(const RawScene& scene, const RawInstance& instance, const RawPrimitive& primitive,
                     const Bound& bound, bool skinned, const BuiltSkeleton& skeleton) {
  const Palette palette = skinned ? bound.palette : bind_to_node(instance.node, skeleton);
  BuiltMesh mesh;
  mesh.name = scene.meshes[static_cast<std::size_t>(instance.mesh)].name;
  if (mesh.name.empty()) mesh.name = scene.nodes[static_cast<std::size_t>(instance.node)].name;
  mesh.geometry = bound.geometry;
  mesh.influences = bound.influences;
  mesh.joints = palette.joints;
  mesh.inverse_bind = palette.inverse_bind;
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
  for (const RawInstance& instance : scene.instances) {
    std::vector<RawPrimitive>& primitives = scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const bool skinned = instance.skin != kNone && !primitives[i].influences.empty();
      const int skin = skinned ? instance.skin : kNone;
      const auto key = std::make_tuple(instance.mesh, i, skin);
      auto found = bound.find(key);
      if (found == bound.end())
        found = bound.emplace(key, bind_primitive(scene, primitives[i], skin, options, out)).first;
      out.meshes.push_back(build_mesh(scene, instance, primitives[i], found->second, skinned, out.skeleton));
    }
  }
}

}  // namespace marrow::cook
