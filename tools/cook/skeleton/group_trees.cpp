#include "cook/skeleton/group_trees.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace marrow::cook {
namespace {

enum Kind { kSkinned, kMoved, kUntouched };

// Sets of trees, each known by its first.
class Sets {
 public:
  explicit Sets(std::size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), std::size_t{0}); }
  std::size_t of(std::size_t tree) {
    while (first_[tree] != tree) tree = first_[tree] = first_[first_[tree]];
    return tree;
  }
  void unite(std::size_t a, std::size_t b) {
    const std::size_t one = of(a), other = of(b);
    first_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::size_t> first_;
};

class Grouping {
 public:
  Grouping(const RawScene& scene, const std::vector<int>& tree_of_node, std::size_t trees)
      : scene_(scene), tree_of_node_(tree_of_node), sets_(trees), kind_(trees, kUntouched), top_(trees, kNone) {
    find_tops();
    join_skins();
    find_moved();
    join_companions();
    join_machines();
  }
  std::vector<std::size_t> numbers();

 private:
  void find_tops();
  void join_skins();
  void find_moved();
  void join_companions();
  void join_machines();

  const RawScene& scene_;
  const std::vector<int>& tree_of_node_;
  Sets sets_;
  std::vector<Kind> kind_;
  std::vector<int> top_;                      // of a tree: the node at the root of the scene that it stands below
  std::vector<std::set<std::size_t>> moved_;  // of a clip: trees
};

void Grouping::find_tops() {
  std::vector<int> top(scene_.nodes.size(), kNone);
  std::vector<std::size_t> way;
  for (std::size_t n = 0; n < top.size(); ++n) {
    std::size_t at = n;
    while (top[at] == kNone && scene_.nodes[at].parent != kNone) {
      way.push_back(at);
      at = static_cast<std::size_t>(scene_.nodes[at].parent);
    }
    if (top[at] == kNone) top[at] = static_cast<int>(at);
    for (; !way.empty(); way.pop_back()) top[way.back()] = top[at];
    if (tree_of_node_[n] != kNone) top_[static_cast<std::size_t>(tree_of_node_[n])] = top[n];
  }
}

void Grouping::join_skins() {
  for (const RawSkin* const skin : skins_in_use(scene_)) {
    const auto tree = [&](int joint) {
      return static_cast<std::size_t>(tree_of_node_[static_cast<std::size_t>(joint)]);
    };
    for (const int joint : skin->joints) {
      kind_[tree(joint)] = kSkinned;
      sets_.unite(tree(skin->joints.front()), tree(joint));
    }
  }
}

void Grouping::find_moved() {
  for (const RawClip& clip : scene_.clips) {
    std::set<std::size_t>& moved = moved_.emplace_back();
    const auto touch = [&](int node) {
      const int tree = tree_of_node_[static_cast<std::size_t>(node)];
      if (tree != kNone) moved.insert(static_cast<std::size_t>(tree));
    };
    for (const RawChannel& channel : clip.channels) touch(channel.node);
    for (const RawScalar& scalar : clip.scalars)
      if (scalar.node != kNone) touch(node_of_weights(scene_, scalar.node));
    for (const std::size_t tree : moved)
      if (kind_[tree] == kUntouched) kind_[tree] = kMoved;
  }
}

// A tree that no skin names joins the skinned skeleton that clips move along with it, if there is just one: below the
// same root of the scene, or else anywhere. Targets of inverse kinematics and weapons stay with their character so.
void Grouping::join_companions() {
  std::map<std::size_t, std::set<std::size_t>> companions;  // of a tree: skinned sets
  for (const std::set<std::size_t>& moved : moved_) {
    std::set<std::size_t> skinned;
    for (const std::size_t tree : moved)
      if (kind_[tree] == kSkinned) skinned.insert(sets_.of(tree));
    for (const std::size_t tree : moved)
      if (kind_[tree] == kMoved) companions[tree].insert(skinned.begin(), skinned.end());
  }
  for (const auto& [tree, all] : companions) {
    std::vector<std::size_t> near;
    std::copy_if(all.begin(), all.end(), std::back_inserter(near),
                 [&, own = tree](std::size_t set) { return top_[set] == top_[own]; });
    if (near.size() != 1) near.assign(all.begin(), all.end());
    if (near.size() != 1) continue;
    sets_.unite(near.front(), tree);
    kind_[tree] = kSkinned;
  }
}

// What has no skin at all: parts below one root of the scene that one clip moves are one machine.
void Grouping::join_machines() {
  for (const std::set<std::size_t>& moved : moved_) {
    std::map<int, std::size_t> first;  // below a root of the scene
    for (const std::size_t tree : moved)
      if (kind_[tree] == kMoved) sets_.unite(first.try_emplace(top_[tree], tree).first->second, tree);
  }
}

std::vector<std::size_t> Grouping::numbers() {
  std::vector<std::size_t> number(kind_.size());
  std::map<std::size_t, std::size_t> of_set;
  for (const Kind kind : {kSkinned, kMoved})
    for (std::size_t tree = 0; tree < kind_.size(); ++tree)
      if (kind_[tree] == kind) number[tree] = of_set.try_emplace(sets_.of(tree), of_set.size()).first->second;
  for (std::size_t tree = 0; tree < kind_.size(); ++tree)
    if (kind_[tree] == kUntouched) number[tree] = of_set.size();
  return number;
}

}  // namespace

std::vector<const RawSkin*> skins_in_use(const RawScene& scene) {
  std::vector<char> used(scene.skins.size(), 0);
  for (const RawInstance& instance : scene.instances)
    if (instance.skin != kNone) used[static_cast<std::size_t>(instance.skin)] = 1;
  const auto in_scene = [&](int joint) { return scene.nodes[static_cast<std::size_t>(joint)].in_scene; };
  std::vector<const RawSkin*> out;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const RawSkin& skin = scene.skins[i];
    if (used[i] != 0 || (scene.instances.empty() && std::all_of(skin.joints.begin(), skin.joints.end(), in_scene)))
      out.push_back(&skin);
  }
  return out;
}

int node_of_weights(const RawScene& scene, int mesh_node) {
  for (const RawInstance& instance : scene.instances)
    if (instance.node == mesh_node && instance.skin != kNone)
      return scene.skins[static_cast<std::size_t>(instance.skin)].joints.front();
  return mesh_node;
}

std::vector<std::size_t> group_trees(const RawScene& scene, const std::vector<int>& tree_of_node, std::size_t trees) {
  return Grouping(scene, tree_of_node, trees).numbers();
}

}  // namespace marrow::cook
