// Which nodes belong to the scene that is cooked, and which of them are drawn.
#include <algorithm>
#include <unordered_set>

#include "cook/gltf/rules/rules.h"
#include "text/nearest.h"

namespace marrow::cook::gltf {
namespace {

using tinygltf::Model;

// Nothing hangs on the node but one other, where it would hang without it.
bool only_carries(const tinygltf::Node& node) {
  const auto is_all = [](const std::vector<double>& numbers, std::vector<double> neutral) {
    return numbers.empty() || numbers == neutral;
  };
  return node.mesh < 0 && node.children.size() == 1 && is_all(node.translation, {0, 0, 0}) &&
         is_all(node.rotation, {0, 0, 0, 1}) && is_all(node.scale, {1, 1, 1}) &&
         is_all(node.matrix, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
}

bool stands_for_its_root(const Model& model, const NodeGraph& graph, int node) {
  for (int up = graph.parent[static_cast<std::size_t>(node)]; up != kNone;
       up = graph.parent[static_cast<std::size_t>(up)])
    if (!only_carries(model.nodes[static_cast<std::size_t>(up)])) return false;
  return true;
}

void check_roots(const Model& model, const NodeGraph& graph, Report& report) {
  for (std::size_t s = 0; s < model.scenes.size(); ++s) {
    const std::vector<int>& nodes = model.scenes[s].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (graph.parent[static_cast<std::size_t>(nodes[i])] == kNone) continue;
      const std::string where = pointer("scenes", s, "nodes", i);
      if (!stands_for_its_root(model, graph, nodes[i]))
        report.invalid(where, "not a root node", "list its topmost ancestor instead");
      report.mend(where, "scene-lists-no-root", "its topmost ancestor is taken, as nothing else hangs on that");
    }
  }
}

std::vector<bool> find_scene_nodes(const Model& model, int scene, const NodeGraph& graph) {
  std::vector<bool> in_scene(model.nodes.size(), scene == kNone);
  if (scene == kNone) return in_scene;
  const std::vector<int>& listed = model.scenes[static_cast<std::size_t>(scene)].nodes;
  std::unordered_set<int> roots;
  for (const int node : listed) roots.insert(graph.root[static_cast<std::size_t>(node)]);
  for (std::size_t i = 0; i < in_scene.size(); ++i) in_scene[i] = roots.contains(graph.root[i]);
  return in_scene;
}

// Why a node is not drawn; what hangs below it is not drawn for the same reason.
enum class Kept : std::uint8_t { unknown, drawn, hidden, lower };

// A node that is a lower level itself makes none of others, so that two that name each other are not both lost.
std::vector<Kept> own_reasons(const Document& document) {
  std::vector<Kept> out(document.node_shown.size(), Kept::unknown);
  for (std::size_t n = 0; n < out.size(); ++n) {
    if (out[n] == Kept::lower) continue;
    if (!document.node_shown[n].visible) out[n] = Kept::hidden;
    for (const int level : document.node_shown[n].lower)
      if (static_cast<std::size_t>(level) != n) out[static_cast<std::size_t>(level)] = Kept::lower;
  }
  return out;
}

// Chains may be too long to recurse along.
std::vector<Kept> reasons(const Document& document, const NodeGraph& graph) {
  std::vector<Kept> out = own_reasons(document);
  std::vector<std::size_t> way;
  for (std::size_t start = 0; start < out.size(); ++start) {
    int at = static_cast<int>(start);
    while (at != kNone && out[static_cast<std::size_t>(at)] == Kept::unknown) {
      way.push_back(static_cast<std::size_t>(at));
      at = graph.parent[static_cast<std::size_t>(at)];
    }
    const Kept found = at == kNone ? Kept::drawn : out[static_cast<std::size_t>(at)];
    for (; !way.empty(); way.pop_back()) out[way.back()] = found;
  }
  return out;
}

std::string name_of(const Model& model, std::size_t node) {
  const std::string& name = model.nodes[node].name;
  return name.empty() ? "nodes[" + std::to_string(node) + ']' : '"' + name + '"';
}

// What stays out, counted and named.
class LeftOut {
 public:
  LeftOut(const Document& document, const NodeGraph& graph, const std::vector<Kept>& kept, Report& report)
      : model_(document.model), graph_(graph), kept_(kept), report_(report) {}

  void say() {
    const auto draws = [&](std::size_t n) { return model_.nodes[n].mesh >= 0; };
    say_those([&](std::size_t n) { return draws(n) && graph_.in_scene[n] && kept_[n] == Kept::hidden; }, "/nodes",
              "hidden-nodes", " nodes are hidden by KHR_node_visibility; their meshes are left out");
    say_those([&](std::size_t n) { return draws(n) && kept_[n] == Kept::lower; }, "/nodes", "lower-levels",
              " nodes are lower levels of detail by MSFT_lod; left out, as --lod makes such levels");
    say_those([&](std::size_t n) { return !graph_.in_scene[n] && kept_[n] != Kept::lower; }, "/scenes",
              "nodes-outside-scene",
              model_.scenes.size() > 1 ? " nodes are not in the scene that is cooked; left out; --scene takes another"
                                       : " nodes are not in the scene; left out");
  }

 private:
  template <class IsOne>
  void say_those(IsOne is_one, const char* where, const char* rule, const char* why) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < kept_.size(); ++n)
      if (is_one(n)) names.push_back(name_of(model_, n));
    if (!names.empty()) report_.warn(where, rule, std::to_string(names.size()) + why + ": " + tools::listed(names));
  }

  const Model& model_;
  const NodeGraph& graph_;
  const std::vector<Kept>& kept_;
  Report& report_;
};

}  // namespace

void choose_nodes(const Document& document, int scene, NodeGraph& graph, Report& report) {
  check_roots(document.model, graph, report);
  graph.in_scene = find_scene_nodes(document.model, scene, graph);
  const std::vector<Kept> kept = reasons(document, graph);
  for (std::size_t n = 0; n < kept.size(); ++n)
    graph.drawn.push_back(graph.in_scene[n] && kept[n] != Kept::hidden && kept[n] != Kept::lower);
  LeftOut(document, graph, kept, report).say();
  if (scene == kNone && !kept.empty()) {
    report.warn("/scenes", "no-scenes", "the file has no scene; all its nodes are cooked");
  }
}

}  // namespace marrow::cook::gltf
