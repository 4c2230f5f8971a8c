// Imports meshes as triangle lists, and their morph targets: what these are called and what they weigh at rest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "cook/gltf/import/import_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint64_t kFreeBytes = std::uint64_t{1} << 28;
constexpr std::uint64_t kMostExpansion = 32;    // Draco reaches about 20 on smooth meshes
constexpr std::uint64_t kBytesPerVertex = 128;  // a RawPrimitive's, with influences

// Degenerate triangles join the parts of a strip and show nothing.
void add_if_visible(std::vector<std::uint32_t>& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a == b || b == c || c == a) return;
  triangles.insert(triangles.end(), {a, b, c});
}

// glTF 2.0, section 3.7.2.1, "Topology types".
std::vector<std::uint32_t> unroll_strip(const std::vector<std::uint32_t>& strip) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    add_if_visible(triangles, strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]);
  }
  return triangles;
}

std::vector<std::uint32_t> unroll_fan(const std::vector<std::uint32_t>& fan) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < fan.size(); ++i) add_if_visible(triangles, fan[i + 1], fan[i + 2], fan[0]);
  return triangles;
}

std::vector<std::uint32_t> import_triangles(VertexSource& source, const tinygltf::Primitive& primitive,
                                            const std::string& where, Report& report) {
  std::vector<std::uint32_t> indices = source.read_vertex_indices();
  switch (source.is_draco() ? TINYGLTF_MODE_TRIANGLES : primitive.mode) {
    case TINYGLTF_MODE_TRIANGLES:
      if (indices.size() % 3 != 0) {
        report.warn(where, "incomplete-triangle",
                    "the vertices are not a multiple of three; the last ones are left out");
        indices.resize(indices.size() / 3 * 3);
      }
      return indices;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      return unroll_strip(indices);
    case TINYGLTF_MODE_TRIANGLE_FAN:
      return unroll_fan(indices);
    default:
      break;
  }
  report.warn(where, "points-and-lines-dropped", "only triangles are drawn");
  return {};
}

RawPrimitive import_primitive(const Document& document, const Materials& materials,
                              const tinygltf::Primitive& primitive, const std::string& where, Budget& budget,
                              Report& report) {
  RawPrimitive raw;
  raw.pointer = where;
  if (!primitive.attributes.contains("POSITION")) {
    report.warn(under(where, "attributes"), "primitive-without-positions", "nothing can be drawn; left out");
    return raw;
  }
  VertexSource source(document, primitive, where, budget, report);
  budget.take(source.count() * kBytesPerVertex, where, report);
  import_positions(source, raw, report);
  raw.indices = import_triangles(source, primitive, where, report);
  import_normals(source, raw, report);
  import_tangents(source, raw, report);
  import_colours(source, raw, report);
  raw.material = primitive.material < 0 ? kNone : primitive.material;
  import_uvs(source, raw.material == kNone ? UvMapping{} : materials.uvs[to_index(raw.material)], raw, report);
  import_targets(document, primitive, where, budget, raw, report);
  import_influences(source, raw, report);
  return raw;
}

}  // namespace

Budget::Budget(std::uint64_t source_bytes) : left_(kFreeBytes + kMostExpansion * source_bytes) {}

void Budget::take(std::uint64_t bytes, const std::string& where, const Report& report) {
  if (bytes > left_) {
    report.unsupported(where, "scene unfolds too far", "the file's data is used over and over; split or export again");
  }
  left_ -= bytes;
}

std::vector<RawMesh> import_meshes(const Document& document, const Materials& materials, Budget& budget,
                                   Report& report) {
  std::vector<RawMesh> meshes;
  for (std::size_t m = 0; m < document.model.meshes.size(); ++m) {
    const tinygltf::Mesh& mesh = document.model.meshes[m];
    RawMesh& raw = meshes.emplace_back();
    raw.name = clean_name(mesh.name, pointer("meshes", m), report);
    raw.weights = mesh_weights(document, m, raw.name, {}, pointer("meshes", m), report);
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string where = pointer("meshes", m, "primitives", p);
      RawPrimitive primitive = import_primitive(document, materials, mesh.primitives[p], where, budget, report);
      budget.take(mesh.primitives.front().targets.size() * sizeof(RawTarget), where, report);
      primitive.targets.resize(mesh.primitives.front().targets.size());
      if (!primitive.indices.empty()) raw.primitives.push_back(std::move(primitive));
    }
  }
  return meshes;
}

namespace {

constexpr float kFarthestChange_m = 1e9F;  // as a position's
constexpr float kLargestTurn = 1e3F;       // of a unit vector; larger ones are damage

// The changes of one attribute; empty where the target has none that can be used. check_meshes() has said why.
std::vector<glm::vec3> read_changes(const Document& document, const std::map<std::string, int>& target,
                                    const std::string& name, std::size_t count, const std::string& where,
                                    Budget& budget, Report& report) {
  const auto found = target.find(name);
  if (found == target.end()) return {};
  const Accessor& accessor = document.accessor(found->second);
  if (accessor.count != count || accessor.shape != Shape::vec3 || !accessor.has_data()) return {};
  const std::string here = under(where, name);
  budget.take(count * 2 * sizeof(glm::vec3), here, report);
  const std::vector<float> values = read_floats(accessor);
  const float most = name == "POSITION" ? kFarthestChange_m : kLargestTurn;
  std::vector<glm::vec3> changes;
  changes.reserve(count);
  std::size_t lost = 0;
  for (std::size_t v = 0; v < count; ++v) {
    const float* from = &values[v * 3];
    if (!std::all_of(from, from + 3, [](float x) { return std::isfinite(x); }))
      report.invalid(here, "not a finite number", "vertex " + std::to_string(v) + "; export again");
    const bool near = std::all_of(from, from + 3, [&](float x) { return std::abs(x) <= most; });
    if (!near) ++lost;
    changes.push_back(near ? glm::vec3(from[0], from[1], from[2]) : glm::vec3(0));
  }
  if (lost > 0)
    report.mend(here, "morph-change-out-of-reach", std::to_string(lost) + " vertices would leave; they stay now");
  return changes;
}

}  // namespace

void import_targets(const Document& document, const tinygltf::Primitive& primitive, const std::string& where,
                    Budget& budget, RawPrimitive& raw, Report& report) {
  const std::size_t count = raw.positions.size();
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    const std::string here = under(where, "targets", t);
    const auto changes = [&](const char* name) {
      return read_changes(document, primitive.targets[t], name, count, here, budget, report);
    };
    RawTarget target;
    target.positions = changes("POSITION");
    if (primitive.attributes.contains("NORMAL")) target.normals = changes("NORMAL");
    if (!raw.tangents.empty()) target.tangents = changes("TANGENT");
    raw.targets.push_back(std::move(target));
  }
}

std::vector<RawTargetWeight> mesh_weights(const Document& document, std::size_t mesh_index, const std::string& owner,
                                          const std::vector<double>& own, const std::string& where, Report& report) {
  std::vector<RawTargetWeight> out;
  const tinygltf::Mesh& mesh = document.model.meshes[mesh_index];
  const std::size_t count = target_count(mesh);
  const std::vector<std::string>& names = document.target_names[mesh_index];
  std::unordered_set<std::string> taken;
  for (std::size_t i = 0; i < count; ++i) {
    // Of two targets with one name the second would get the first one's weight.
    const bool named = i < names.size() && !names[i].empty() && taken.insert(names[i]).second;
    const double rest = own.size() == count ? own[i] : mesh.weights.size() == count ? mesh.weights[i] : 0.0;
    constexpr double kMost = std::numeric_limits<float>::max();
    out.push_back({clean_name(i < names.size() ? names[i] : "", where, report),
                   clean_name(owner + (named ? '.' + names[i] : ".weights[" + std::to_string(i) + ']'), where, report),
                   static_cast<float>(std::clamp(rest, -kMost, kMost))});
  }
  return out;
}

std::vector<RawTargetWeight> node_weights(const Document& document, const std::vector<std::string>& owners,
                                          int node_index, const std::string& where, Report& report) {
  const auto n = to_index(node_index);
  const tinygltf::Node& node = document.model.nodes[n];
  if (node.mesh < 0) return {};
  return mesh_weights(document, to_index(node.mesh), owners[n], node.weights, where, report);
}

std::vector<std::string> weight_owners(const Document& document, const std::vector<RawNode>& nodes) {
  std::vector<std::string> owners;
  std::unordered_set<std::string> taken;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const int mesh = document.model.nodes[n].mesh;
    const bool morphs = mesh >= 0 && target_count(document.model.meshes[to_index(mesh)]) > 0;
    const bool own = !nodes[n].name.empty() && (!morphs || taken.insert(nodes[n].name).second);
    owners.push_back(own ? nodes[n].name : "nodes[" + std::to_string(n) + ']');
  }
  return owners;
}

}  // namespace marrow::cook::gltf
