// Rules about nodes, scenes, skins and animations: which nodes belong to the scene that is cooked, which of them are
// drawn, and what moves them.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "cook/gltf/rules/rules.h"
#include "text/nearest.h"

namespace marrow::cook::gltf {
namespace {

using tinygltf::Model;
using tinygltf::Node;

// Nothing hangs on the node but one other, where it would hang without it.
bool only_carries(const Node& node) {
  const auto is_all = [](const std::vector<double>& numbers, std::vector<double> neutral) {
    return numbers.empty() || numbers == neutral;
  };
  return node.mesh < 0 && node.children.size() == 1 && is_all(node.translation, {0, 0, 0}) &&
         is_all(node.rotation, {0, 0, 0, 1}) && is_all(node.scale, {1, 1, 1}) &&
         is_all(node.matrix, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
}

bool stands_for_its_root(const Model& model, const NodeGraph& graph, int node) {
  for (int up = graph.parent[to_index(node)]; up != kNone; up = graph.parent[to_index(up)])
    if (!only_carries(model.nodes[to_index(up)])) return false;
  return true;
}

void check_roots(const Model& model, const NodeGraph& graph, Report& report) {
  for (std::size_t s = 0; s < model.scenes.size(); ++s) {
    const std::vector<int>& nodes = model.scenes[s].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (graph.parent[to_index(nodes[i])] == kNone) continue;
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
  const std::vector<int>& listed = model.scenes[to_index(scene)].nodes;
  std::unordered_set<int> roots;
  for (const int node : listed) roots.insert(graph.root[to_index(node)]);
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
      if (to_index(level) != n) out[to_index(level)] = Kept::lower;
  }
  return out;
}

// Chains may be too long to recurse along.
std::vector<Kept> reasons(const Document& document, const NodeGraph& graph) {
  std::vector<Kept> out = own_reasons(document);
  std::vector<std::size_t> way;
  for (std::size_t start = 0; start < out.size(); ++start) {
    int at = static_cast<int>(start);
    while (at != kNone && out[to_index(at)] == Kept::unknown) {
      way.push_back(to_index(at));
      at = graph.parent[to_index(at)];
    }
    const Kept found = at == kNone ? Kept::drawn : out[to_index(at)];
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

// Scenes list roots, and what stays out is said. Needs parents and roots, gives the rest.
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

std::vector<int> find_parents(const Model& model, Report& report) {
  std::vector<int> parent(model.nodes.size(), kNone);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const std::vector<int>& children = model.nodes[i].children;
    for (std::size_t c = 0; c < children.size(); ++c) {
      int& of_child = parent[to_index(children[c])];
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
      at = to_index(parent[at]);
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
  const std::size_t targets = target_count(model.meshes[to_index(node.mesh)]);
  if (!node.weights.empty() && node.weights.size() != targets) {
    report.mend(under(where, "weights"), "morph-weights-wrong", "one a morph target is needed; ignored");
  }
}

// Whether `ancestor` is `node` or above it is asked for many nodes; the answer is spread downwards instead.
bool is_above_all(int ancestor, const std::vector<int>& nodes, const NodeGraph& graph) {
  enum State : std::uint8_t { unknown, yes, no };
  std::vector<State> state(graph.parent.size(), unknown);
  state[to_index(ancestor)] = yes;
  std::vector<std::size_t> way;
  for (const int node : nodes) {
    way.clear();
    int at = node;
    while (at != kNone && state[to_index(at)] == unknown) {
      way.push_back(to_index(at));
      at = graph.parent[to_index(at)];
    }
    const State found = at == kNone ? no : state[to_index(at)];
    for (const std::size_t passed : way) state[passed] = found;
    if (found == no) return false;
  }
  return true;
}

void check_inverse_binds(const Document& document, std::size_t index, Report& report) {
  const tinygltf::Skin& skin = document.model.skins[index];
  if (skin.inverseBindMatrices < 0) return;
  const std::string where = pointer("skins", index, "inverseBindMatrices");
  const Accessor& accessor = document.accessor(skin.inverseBindMatrices);
  if (accessor.shape != Shape::mat4 || accessor.component != Component::f32) {
    report.invalid(where, "wrong accessor", "inverse bind matrices are float MAT4; export again");
  }
  if (accessor.count < skin.joints.size()) {
    report.invalid(
        where, "too few matrices",
        std::to_string(accessor.count) + " for " + std::to_string(skin.joints.size()) + " joints; export again");
  }
  if (accessor.view >= 0 && document.view(accessor.view).stride != 0) {
    report.mend(where, "stride-not-allowed", "only vertex data may have a byteStride; honoured all the same");
  }
}

// joints.size() if all are inside.
std::size_t first_outside_scene(const std::vector<int>& joints, const NodeGraph& graph) {
  const auto found = std::ranges::find_if(joints, [&](int joint) { return !graph.in_scene[to_index(joint)]; });
  return static_cast<std::size_t>(found - joints.begin());
}

// is_used: by a node of the scene.
void check_skin(const Document& document, std::size_t index, bool is_used, const NodeGraph& graph, Report& report) {
  const tinygltf::Skin& skin = document.model.skins[index];
  const int root = graph.root[to_index(skin.joints.front())];
  const std::size_t stray = first_outside_scene(skin.joints, graph);
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    if (graph.root[to_index(skin.joints[j])] == root) continue;
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
    if (model.nodes[i].skin >= 0 && graph.in_scene[i]) is_used[to_index(model.nodes[i].skin)] = true;
  std::vector<bool> in_scene;
  for (std::size_t i = 0; i < model.skins.size(); ++i) {
    check_skin(document, i, is_used[i], graph, report);
    in_scene.push_back(first_outside_scene(model.skins[i].joints, graph) == model.skins[i].joints.size());
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Node& node = model.nodes[i];
    if (node.skin < 0 || !graph.in_scene[i]) continue;
    if (!in_scene[to_index(node.skin)]) {
      report.invalid(pointer("nodes", i, "skin"), "joints outside the scene", "put the skeleton's root into the scene");
    }
  }
}

namespace {

class AnimationChecker {
 public:
  AnimationChecker(const Document& document, std::size_t index, std::vector<bool>& times_checked, Report& report)
      : document_(document),
        animation_(document.model.animations[index]),
        index_(index),
        where_(pointer("animations", index)),
        times_checked_(times_checked),
        report_(report) {}

  void check() {
    for (std::size_t s = 0; s < animation_.samplers.size(); ++s) check_sampler(s);
    for (std::size_t c = 0; c < animation_.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation_.channels[c];
      if (channel.target_path.empty()) continue;  // left out already
      const std::string where = under(where_, "channels", c);
      if (channel.sampler < 0 || to_index(channel.sampler) >= animation_.samplers.size()) {
        report_.invalid(under(where, "sampler"), "reference to nothing",
                        "the animation has " + std::to_string(animation_.samplers.size()) + " samplers; export again");
      }
      const auto number = document_.user_numbers.find({index_, c});
      const bool is_number = number != document_.user_numbers.end();
      is_number ? check_number(channel, where) : check_channel(channel, where);
      if (accessor(animation_.samplers[to_index(channel.sampler)].input).count == 0)
        report_.mend(under(where, "sampler"), "channel-without-keys", "it moves nothing; left out");
    }
  }

 private:
  const Accessor& accessor(int index) const { return document_.accessor(index); }

  void refuse_stride(const Accessor& data, const std::string& where) {
    if (data.view < 0 || document_.view(data.view).stride == 0) return;
    report_.mend(where, "stride-not-allowed", "only vertex data may have a byteStride; honoured all the same");
  }

  void check_sampler(std::size_t index) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[index];
    const std::string where = under(where_, "samplers", index);
    const Accessor& input = accessor(sampler.input);
    const std::string input_where = under(where, "input");
    if (input.shape != Shape::scalar || input.component != Component::f32) {
      report_.invalid(input_where, "wrong accessor", "times are float scalars; export again");
    }
    if (input.count == 0) return;
    if (!input.has_bounds) report_.mend(input_where, "bounds-missing", "times need min and max; computed instead");
    if (sampler.interpolation == "CUBICSPLINE" && input.count < 2) {
      report_.mend(input_where, "too-few-keys", "a cubic spline needs two keys; held at the one there is");
    }
    check_times(sampler.input, input_where);
    refuse_stride(input, input_where);
    refuse_stride(accessor(sampler.output), under(where, "output"));
  }

  // Equal times are left to the import, which can mend them.
  void check_times(int index, const std::string& where) {
    if (times_checked_[to_index(index)]) return;
    times_checked_[to_index(index)] = true;
    const Accessor& input = accessor(index);
    if (!input.has_data()) return;
    ElementReader reader(input);
    double previous = 0;
    for (std::uint64_t i = 0; i < input.count; ++i) {
      double time = 0;
      reader.read_raw(i, &time);
      const std::string which = "key " + std::to_string(i);
      if (!std::isfinite(time)) report_.invalid(where, "not a finite number", which + "; export again");
      if (time < 0) report_.invalid(where, "negative time", which + "; export again");
      if (time < previous) report_.invalid(where, "times must increase", which + "; export again");
      previous = time;
    }
  }

  void check_channel(const tinygltf::AnimationChannel& channel, const std::string& where) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[to_index(channel.sampler)];
    const tinygltf::Node& node = document_.model.nodes[to_index(channel.target_node)];
    const Accessor& output = accessor(sampler.output);
    const std::string sampler_where = under(where, "sampler");
    const bool is_weights = channel.target_path == "weights";
    const bool is_rotation = channel.target_path == "rotation";
    const Shape shape = is_weights ? Shape::scalar : is_rotation ? Shape::vec4 : Shape::vec3;
    const bool integer_allowed = is_weights || is_rotation;
    if (output.shape != shape || (output.component != Component::f32 && !(integer_allowed && output.normalised))) {
      report_.invalid(sampler_where, "wrong output accessor", "see glTF 2.0, section 3.11; export again");
    }
    std::uint64_t factor = sampler.interpolation == "CUBICSPLINE" ? 3 : 1;
    if (is_weights) factor *= check_morph_target(node, under(where, "target"));
    if (factor != 0) check_count(sampler, factor, sampler_where);
    if (!is_weights && !node.matrix.empty()) {
      report_.mend(under(where, "target"), "animated-matrix", "an animated node has no matrix; it is decomposed");
    }
  }

  // Whole numbers stand for themselves, as KHR_animation_pointer has it.
  void check_number(const tinygltf::AnimationChannel& channel, const std::string& where) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[to_index(channel.sampler)];
    const std::string sampler_where = under(where, "sampler");
    if (accessor(sampler.output).shape != Shape::scalar) {
      report_.invalid(sampler_where, "wrong output accessor", "a number needs scalars; export again");
    }
    check_count(sampler, sampler.interpolation == "CUBICSPLINE" ? 3 : 1, sampler_where);
  }

  void check_count(const tinygltf::AnimationSampler& sampler, std::uint64_t values_a_key, const std::string& where) {
    const std::uint64_t count = accessor(sampler.output).count, needed = accessor(sampler.input).count * values_a_key;
    if (count == needed) return;
    report_.invalid(where, "times and values differ in count",
                    std::to_string(count) + " values where " + std::to_string(needed) + " are needed; export again");
  }

  // How many weights a key has.
  std::size_t check_morph_target(const tinygltf::Node& node, const std::string& where) {
    const std::size_t count = node.mesh < 0 ? 0 : target_count(document_.model.meshes[to_index(node.mesh)]);
    if (count == 0) report_.mend(where, "no-morph-targets", "the node has no morph targets to animate; left out");
    return count;
  }

  const Document& document_;
  const tinygltf::Animation& animation_;
  std::size_t index_;
  std::string where_;
  std::vector<bool>& times_checked_;  // by accessor: samplers share them by the hundred
  Report& report_;
};

}  // namespace

void check_animations(const Document& document, Report& report) {
  std::vector<bool> times_checked(document.accessors.size());
  for (std::size_t i = 0; i < document.model.animations.size(); ++i) {
    AnimationChecker(document, i, times_checked, report).check();
  }
}

}  // namespace marrow::cook::gltf
