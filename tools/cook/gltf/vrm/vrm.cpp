#include "cook/gltf/vrm/vrm.h"

#include <algorithm>
#include <cmath>

#include "cook/gltf/vrm/vrm_parts.h"
#include "cook/scene/matrices.h"

namespace marrow::cook::gltf {
namespace {

std::vector<glm::dmat4> model_from_nodes(const std::vector<RawNode>& nodes) {
  std::vector<glm::dmat4> out(nodes.size());
  std::vector<char> known(nodes.size(), 0);
  std::vector<std::size_t> way;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    std::size_t at = n;
    while (!known[at]) {
      way.push_back(at);
      if (nodes[at].parent == kNone) break;
      at = static_cast<std::size_t>(nodes[at].parent);
    }
    for (; !way.empty(); way.pop_back()) {
      const RawNode& node = nodes[way.back()];
      const glm::dmat4 local = local_matrix(node);
      out[way.back()] = node.parent == kNone ? local : out[static_cast<std::size_t>(node.parent)] * local;
      known[way.back()] = 1;
    }
  }
  return out;
}

bool uses(const Document& document, const char* extension) {
  return std::ranges::count(document.model.extensionsUsed, extension) > 0;
}

}  // namespace

const Json& member_or_empty(const Json& object, const char* name) {
  static const Json kEmpty;
  const auto found = object.find(name);
  return found == object.end() ? kEmpty : *found;
}

double number_or(const Json& object, const char* name, double fallback) {
  const auto found = object.find(name);
  return found == object.end() ? fallback : found->get<double>();
}

std::string text_or(const Json& object, const char* name, const std::string& fallback) {
  const auto found = object.find(name);
  return found == object.end() ? fallback : found->get<std::string>();
}

glm::dvec3 vector_or(const Json& object, const char* name, const glm::dvec3& fallback) {
  const auto found = object.find(name);
  if (found == object.end()) return fallback;
  if (found->is_array()) return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
  return {number_or(*found, "x", 0), number_or(*found, "y", 0), number_or(*found, "z", 0)};
}

bool names_one(const Json& number, std::size_t count) {
  if (!number.is_number()) return false;
  const double index = number.get<double>();
  return index >= 0 && index < static_cast<double>(count) && index == std::floor(index);
}

void import_vrm(const Document& document, Budget& budget, Report& report, RawScene& scene) {
  VrmImport vrm{document, budget, report, scene, false, Json::object(), "", {}};
  if (uses(document, "VRMC_node_constraint"))
    report.warn("/nodes", "constraints-dropped", "VRMC_node_constraint: nobody turns these nodes after others");
  if (!document.vrm.is_object()) return;
  vrm.is_0 = !document.vrm.contains("VRMC_vrm") && document.vrm.contains("VRM");
  const char* const name = vrm.is_0 ? "VRM" : "VRMC_vrm";
  if (document.vrm.contains(name)) vrm.vrm = document.vrm.at(name);
  vrm.where = pointer("extensions", name);
  vrm.model_from_node = model_from_nodes(scene.nodes);
  if (!vrm.vrm.empty()) {
    import_properties(vrm);
    import_expressions(vrm);
    import_eyes(vrm);
  }
  import_springs(vrm);
}

}  // namespace marrow::cook::gltf
