// Rules about nodes and skins.
#include <algorithm>

#include "cook/gltf/rules/rules.h"

namespace marrow::cook::gltf {
namespace {

using tinygltf::Model;
using tinygltf::Node;

std::vector<int> find_parents(const Model& model, Report& report) {
  std::vector<int> parent(model.nodes.size(), kNone);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const std::vector<int>& children = model.nodes[i].children;
    for (std::size_t c = 0; c < children.size(); ++c) {
      int& of_child = parent[static_cast<std::size_t>(children[c])];
      if (of_child != kNone) {
        report.invalid(pointer("nodes", i, "children", c), "node with two parents",
                       "/nodes/" + std::to_string(of_child) + " lists it too; export again");
      }
      of_child = static_cast<int>(i);
    }
  }
  return parent;
}

// Every node has one parent at most, so walking up finds either a root or a loop; each step is done once.
std::vector<int> find_roots(const std::vector<int>& parent, Report& report) {
  constexpr int kUnknown = -2;
  constexpr int kOnTheWay = -3;
  std::vector<int> root(parent.size(), kUnknown);
  std::vector<std::size_t> way;
  for (std::size_t start = 0; start < parent.size(); ++start) {
    std::size_t at = start;
    way.clear();
    while (root[at] == kUnknown) {
      root[at] = kOnTheWay;
      way.push_back(at);
      if (parent[at] == kNone) break;
      at = static_cast<std::size_t>(parent[at]);
    }
    if (root[at] == kOnTheWay && parent[at] != kNone) {
      report.invalid(pointer("nodes", at), "node loop", "the node is its own ancestor; export again");
    }
    const int found = root[at] == kOnTheWay ? static_cast<int>(at) : root[at];
    for (const std::size_t node : way) root[node] = found;
  }
  return root;
}

void check_node(const Model& model, std::size_t index, Report& report) {
  const Node& node = model.nodes[index];
  const std::string where = pointer("nodes", index);
  if (node.mesh < 0) {
    if (node.skin >= 0) report.invalid(under(where, "skin"), "skin without mesh", "export again");
    if (!node.weights.empty()) report.invalid(under(where, "weights"), "weights without mesh", "export again");
    return;
  }
  const std::size_t targets = target_count(model.meshes[static_cast<std::size_t>(node.mesh)]);
  if (!node.weights.empty() && node.weights.size() != targets) {
    report.mend(under(where, "weights"), "morph-weights-wrong", "one a morph target is needed; ignored");
  }
}

// Whether `ancestor` is `node` or above it is asked for many nodes; the answer is spread downwards instead.
bool is_above_all(int ancestor, const std::vector<int>& nodes, const NodeGraph& graph) {
  enum State : std::uint8_t { unknown, yes, no };
  std::vector<State> state(graph.parent.size(), unknown);
  state[static_cast<std::size_t>(ancestor)] = yes;
  std::vector<std::size_t> way;
  for (const int node : nodes) {
    way.clear();
    int at = node;
    while (at != kNone && state[static_cast<std::size_t>(at)] == unknown) {
      way.push_back(static_cast<std::size_t>(at));
      at = graph.parent[static_cast<std::size_t>(at)];
    }
    const State found = at == kNone ? no : state[static_cast<std::size_t>(at)];
    for (const std::size_t passed : way) state[passed] = found;
    if (found == no) return false;
  }
  return true;
}

void check_inverse_binds(const Document& document, std::size_t index, Report& report) {
  const tinygltf::Skin& skin = document.model.skins[index];
  if (skin.inverseBindMatrices < 0) return;
  const std::string where = pointer("skins", index, "inverseBindMatrices");
  const Accessor& accessor = document.accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
  if (accessor.shape != Shape::mat4 || accessor.component != Component::f32) {
    report.invalid(where, "wrong accessor", "inverse bind matrices are float MAT4; export again");
  }
  if (accessor.count < skin.joints.size()) {
    report.invalid(
        where, "too few matrices",
        std::to_string(accessor.count) + " for " + std::to_string(skin.joints.size()) + " joints; export again");
  }
  if (accessor.view >= 0 && document.buffers.views[static_cast<std::size_t>(accessor.view)].stride != 0) {
    report.mend(where, "stride-not-allowed", "only vertex data may have a byteStride; honoured all the same");
  }
}

// joints.size() if all are inside.
std::size_t first_outside_scene(const std::vector<int>& joints, const NodeGraph& graph) {
  const auto found =
      std::ranges::find_if(joints, [&](int joint) { return !graph.in_scene[static_cast<std::size_t>(joint)]; });
  return static_cast<std::size_t>(found - joints.begin());
}

// is_used: by a node of the scene.
void check_skin(const Document& document, std::size_t index, bool is_used, const NodeGraph& graph, Report& report) {
  const tinygltf::Skin& skin = document.model.skins[index];
  const int root = graph.root[static_cast<std::size_t>(skin.joints.front())];
  const std::size_t stray = first_outside_scene(skin.joints, graph);
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    if (graph.root[static_cast<std::size_t>(skin.joints[j])] == root) continue;
    if (is_used && stray < skin.joints.size()) {
      report.invalid(pointer("skins", index, "joints", stray), "no common root",
                     "a joint is outside the scene; export again");
    }
    report.mend(pointer("skins", index, "joints", j), "no-common-root",
                "not in the first joint's tree; the scene joins them");
    break;
  }
  if (skin.skeleton >= 0 && !is_above_all(skin.skeleton, skin.joints, graph)) {
    report.mend(pointer("skins", index, "skeleton"), "skeleton-not-above-joints",
                "not an ancestor of all joints; ignored");
  }
  check_inverse_binds(document, index, report);
}

}  // namespace

void check_transforms(const Json& root, const Report& report) {
  const auto nodes = root.find("nodes");
  if (nodes == root.end()) return;
  for (std::size_t i = 0; i < nodes->size(); ++i) {
    const Json& node = (*nodes)[i];
    const bool has_parts = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (has_parts && node.contains("matrix"))
      report.invalid(pointer("nodes", i, "matrix"), "both matrix and TRS", "give one of them; export again");
  }
}

NodeGraph check_nodes(const Document& document, int scene, Report& report) {
  const Model& model = document.model;
  NodeGraph graph;
  graph.parent = find_parents(model, report);
  graph.root = find_roots(graph.parent, report);
  choose_nodes(document, scene, graph, report);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) check_node(model, i, report);
  return graph;
}

void check_skins(const Document& document, const NodeGraph& graph, Report& report) {
  const Model& model = document.model;
  std::vector<bool> is_used(model.skins.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].skin >= 0 && graph.in_scene[i]) is_used[static_cast<std::size_t>(model.nodes[i].skin)] = true;
  std::vector<bool> in_scene;
  for (std::size_t i = 0; i < model.skins.size(); ++i) {
    check_skin(document, i, is_used[i], graph, report);
    in_scene.push_back(first_outside_scene(model.skins[i].joints, graph) == model.skins[i].joints.size());
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Node& node = model.nodes[i];
    if (node.skin < 0 || !graph.in_scene[i]) continue;
    if (!in_scene[static_cast<std::size_t>(node.skin)]) {
      report.invalid(pointer("nodes", i, "skin"), "joints outside the scene", "put the skeleton's root into the scene");
    }
  }
}

}  // namespace marrow::cook::gltf
