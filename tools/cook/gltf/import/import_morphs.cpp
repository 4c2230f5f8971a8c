// Reads morph targets: what they add to vertices, what they are called and what they weigh at rest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "cook/gltf/import/import_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr float kFarthestChange_m = 1e9F;  // as a position's
constexpr float kLargestTurn = 1e3F;       // of a unit vector; larger ones are damage

// The changes of one attribute; empty where the target has none that can be used. check_meshes() has said why.
std::vector<glm::vec3> read_changes(const Document& document, const std::map<std::string, int>& target,
                                    const std::string& name, std::size_t count, const std::string& where,
                                    Budget& budget, Report& report) {
  const auto found = target.find(name);
  if (found == target.end()) return {};
  const Accessor& accessor = document.accessors[static_cast<std::size_t>(found->second)];
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
  const auto n = static_cast<std::size_t>(node_index);
  const tinygltf::Node& node = document.model.nodes[n];
  if (node.mesh < 0) return {};
  return mesh_weights(document, static_cast<std::size_t>(node.mesh), owners[n], node.weights, where, report);
}

std::vector<std::string> weight_owners(const Document& document, const std::vector<RawNode>& nodes) {
  std::vector<std::string> owners;
  std::unordered_set<std::string> taken;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const int mesh = document.model.nodes[n].mesh;
    const bool morphs = mesh >= 0 && target_count(document.model.meshes[static_cast<std::size_t>(mesh)]) > 0;
    const bool own = !nodes[n].name.empty() && (!morphs || taken.insert(nodes[n].name).second);
    owners.push_back(own ? nodes[n].name : "nodes[" + std::to_string(n) + ']');
  }
  return owners;
}

}  // namespace marrow::cook::gltf
