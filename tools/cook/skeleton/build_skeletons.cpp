#include "cook/skeleton/build_skeletons.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "common/failure.h"
#include "cook/scene/matrices.h"
#include "cook/scene/without_tiny.h"

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

  std::vector<std::size_t> numbers() {
    std::vector<std::size_t> number(kind_.size());
    std::map<std::size_t, std::size_t> of_set;
    for (const Kind kind : {kSkinned, kMoved})
      for (std::size_t tree = 0; tree < kind_.size(); ++tree)
        if (kind_[tree] == kind) number[tree] = of_set.try_emplace(sets_.of(tree), of_set.size()).first->second;
    for (std::size_t tree = 0; tree < kind_.size(); ++tree)
      if (kind_[tree] == kUntouched) number[tree] = of_set.size();
    return number;
  }

 private:
  void find_tops() {
    std::vector<int> top(scene_.nodes.size(), kNone);
    std::vector<std::size_t> way;
    for (std::size_t n = 0; n < top.size(); ++n) {
      std::size_t at = n;
      while (top[at] == kNone && scene_.nodes[at].parent != kNone) {
        way.push_back(at);
        at = to_index(scene_.nodes[at].parent);
      }
      if (top[at] == kNone) top[at] = static_cast<int>(at);
      for (; !way.empty(); way.pop_back()) top[way.back()] = top[at];
      if (tree_of_node_[n] != kNone) top_[to_index(tree_of_node_[n])] = top[n];
    }
  }

  void join_skins() {
    for (const RawSkin* const skin : skins_in_use(scene_)) {
      const auto tree = [&](int joint) { return to_index(tree_of_node_[to_index(joint)]); };
      for (const int joint : skin->joints) {
        kind_[tree(joint)] = kSkinned;
        sets_.unite(tree(skin->joints.front()), tree(joint));
      }
    }
  }

  void find_moved() {
    for (const RawClip& clip : scene_.clips) {
      std::set<std::size_t>& moved = moved_.emplace_back();
      const auto touch = [&](int node) {
        const int tree = tree_of_node_[to_index(node)];
        if (tree != kNone) moved.insert(to_index(tree));
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
  void join_companions() {
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
  void join_machines() {
    for (const std::set<std::size_t>& moved : moved_) {
      std::map<int, std::size_t> first;  // below a root of the scene
      for (const std::size_t tree : moved)
        if (kind_[tree] == kMoved) sets_.unite(first.try_emplace(top_[tree], tree).first->second, tree);
    }
  }

  const RawScene& scene_;
  const std::vector<int>& tree_of_node_;
  Sets sets_;
  std::vector<Kind> kind_;
  std::vector<int> top_;                      // of a tree: the node at the root of the scene that it stands below
  std::vector<std::set<std::size_t>> moved_;  // of a clip: trees
};

std::vector<char> choose_joints(const RawScene& scene, const std::vector<std::size_t>& order) {
  std::vector<char> joint = named_or_moved(scene);
  std::vector<char> rigid(scene.nodes.size(), 0), above(scene.nodes.size(), 0), below(scene.nodes.size(), 0);
  for (const RawInstance& instance : scene.instances)
    for (const RawPrimitive& primitive : scene.meshes[to_index(instance.mesh)].primitives)
      if (instance.skin == kNone || primitive.influences.empty()) rigid[to_index(instance.node)] = 1;
  const auto parent_of = [&](std::size_t n) { return to_index(scene.nodes[n].parent); };
  const auto has_parent = [&](std::size_t n) { return scene.nodes[n].parent != kNone; };
  for (const std::size_t n : order) {
    above[n] = has_parent(n) && (above[parent_of(n)] || joint[parent_of(n)]);
    if (rigid[n] && !above[n]) joint[n] = 1;
  }
  for (std::size_t i = order.size(); i-- > 0;) {
    const std::size_t n = order[i];
    if (has_parent(n) && (joint[n] || below[n])) below[parent_of(n)] = 1;
  }
  for (const std::size_t n : order)
    if (above[n] && below[n]) joint[n] = 1;  // what lies between two joints moves with the upper one
  return joint;
}

// Joints of each skeleton: roots first, then their children, then theirs; within a level by parent, within a parent by
// node number.
std::vector<std::vector<int>> breadth_first(const RawScene& scene, const std::vector<char>& joint,
                                            const std::vector<std::size_t>& order) {
  std::vector<std::vector<int>> children(scene.nodes.size());
  std::vector<int> roots, tree_of_node(scene.nodes.size(), kNone);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!joint[i]) continue;
    const int parent = scene.nodes[i].parent;
    const bool root = parent == kNone || !joint[to_index(parent)];
    if (root) tree_of_node[i] = static_cast<int>(roots.size());
    (root ? roots : children[to_index(parent)]).push_back(static_cast<int>(i));
  }
  for (const std::size_t n : order)
    if (tree_of_node[n] == kNone && scene.nodes[n].parent != kNone)
      tree_of_node[n] = tree_of_node[to_index(scene.nodes[n].parent)];
  const std::vector<std::size_t> skeleton_of_tree = group_trees(scene, tree_of_node, roots.size());
  std::vector<std::vector<int>> out;
  for (std::size_t tree = 0; tree < roots.size(); ++tree) {
    out.resize(std::max(out.size(), skeleton_of_tree[tree] + 1));
    out[skeleton_of_tree[tree]].push_back(roots[tree]);
  }
  for (std::vector<int>& joints : out)
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const std::vector<int>& next = children[to_index(joints[i])];
      joints.insert(joints.end(), next.begin(), next.end());
    }
  return out;
}

void number_joints(const RawScene& scene, const std::vector<std::vector<int>>& skeletons,
                   const std::vector<std::size_t>& order, BuiltScene& out) {
  out.joint_of_node.assign(scene.nodes.size(), kNone);
  out.nearest.assign(scene.nodes.size(), {});
  for (std::size_t s = 0; s < skeletons.size(); ++s) {
    if (skeletons[s].size() > kMaxJoints)
      throw tools::Failure(
          tools::Exit::unsupported, scene.source, "/nodes", "too-many-joints",
          std::to_string(skeletons[s].size()) + " joints in one skeleton; the most is " + std::to_string(kMaxJoints));
    for (std::size_t j = 0; j < skeletons[s].size(); ++j) {
      const auto node = to_index(skeletons[s][j]);
      out.joint_of_node[node] = static_cast<int>(j);
      out.nearest[node] = {static_cast<int>(s), static_cast<int>(j), glm::dmat4(1.0)};
    }
  }
  for (const std::size_t n : order)
    if (out.joint_of_node[n] == kNone) place_below_parent(scene, n, out.nearest);
}

BuiltSkeleton build_skeleton(const RawScene& scene, std::vector<int> joints, const std::vector<NearestJoint>& nearest) {
  BuiltSkeleton out;
  out.rest.assign(soa_count(joints.size()), kRestOfNone);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const RawNode& node = scene.nodes[to_index(joints[j])];
    const NearestJoint up = node.parent == kNone ? NearestJoint{} : nearest[to_index(node.parent)];
    out.joint_names.push_back(node.name);
    out.parents.push_back(up.joint == kNone ? kNoJoint : static_cast<std::uint16_t>(up.joint));
    if (up.joint == kNone) out.model_from_root.push_back(to_affine(up.joint_from_node));
    set_rest(node, j, out);
  }
  out.node_of_joint = std::move(joints);
  out.name = out.joint_names.front();
  return out;
}

}  // namespace

std::vector<const RawSkin*> skins_in_use(const RawScene& scene) {
  std::vector<char> used(scene.skins.size(), 0);
  for (const RawInstance& instance : scene.instances)
    if (instance.skin != kNone) used[to_index(instance.skin)] = 1;
  const auto in_scene = [&](int joint) { return scene.nodes[to_index(joint)].in_scene; };
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
      return scene.skins[to_index(instance.skin)].joints.front();
  return mesh_node;
}

std::vector<std::size_t> group_trees(const RawScene& scene, const std::vector<int>& tree_of_node, std::size_t trees) {
  return Grouping(scene, tree_of_node, trees).numbers();
}

Descent::Descent(const std::vector<std::uint16_t>& parents) : first_(parents.size()), end_(parents.size()) {
  std::vector<std::uint32_t> below(parents.size(), 1), next(parents.size());  // joints; where a child's walk begins
  for (std::size_t j = below.size(); j-- > 0;)
    if (parents[j] != kNoJoint) below[parents[j]] += below[j];
  std::uint32_t roots = 0;
  for (std::size_t j = 0; j < below.size(); ++j) {
    std::uint32_t& at = parents[j] == kNoJoint ? roots : next[parents[j]];
    first_[j] = at;
    next[j] = at + 1;
    end_[j] = at += below[j];
  }
}

std::vector<Mesh> meshes_of(const std::vector<Mesh>& meshes, std::size_t skeleton) {
  std::vector<Mesh> out;
  std::ranges::copy_if(meshes, std::back_inserter(out), [&](const Mesh& mesh) { return mesh.skeleton == skeleton; });
  return out;
}

std::vector<std::size_t> parents_first(const RawScene& scene) {
  std::vector<std::vector<std::size_t>> children(scene.nodes.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const int parent = scene.nodes[i].parent;
    (parent == kNone ? order : children[to_index(parent)]).push_back(i);
  }
  for (std::size_t i = 0; i < order.size(); ++i)
    order.insert(order.end(), children[order[i]].begin(), children[order[i]].end());
  return order;
}

std::vector<char> named_or_moved(const RawScene& scene) {
  std::vector<char> joint(scene.nodes.size(), 0);
  for (const RawSkin* const skin : skins_in_use(scene))
    for (const int node : skin->joints) joint[to_index(node)] = 1;
  for (const RawClip& clip : scene.clips)
    for (const RawChannel& channel : clip.channels)
      if (scene.nodes[to_index(channel.node)].in_scene) joint[to_index(channel.node)] = 1;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    if (scene.nodes[n].moved_by_game && scene.nodes[n].in_scene) joint[n] = 1;
  return joint;
}

void place_below_parent(const RawScene& scene, std::size_t node, std::vector<NearestJoint>& nearest) {
  const RawNode& raw = scene.nodes[node];
  if (raw.parent != kNone) nearest[node] = nearest[to_index(raw.parent)];
  nearest[node].joint_from_node = nearest[node].joint_from_node * local_matrix(raw);
}

// As the source has it, without what is as good as 0.
void set_rest(const RawNode& node, std::size_t joint, BuiltSkeleton& skeleton) {
  SoaTransform& four = skeleton.rest[joint / 4];
  const std::size_t lane = joint % 4;
  for (int axis = 0; axis < 3; ++axis) {
    four.translation[axis][lane] = without_tiny(node.translation[axis]);
    four.scale[axis][lane] = static_cast<float>(node.scale[axis]);
  }
  const glm::dquat& q = node.rotation;
  const double xyzw[4] = {q.x, q.y, q.z, q.w};
  for (int i = 0; i < 4; ++i) four.rotation[i][lane] = without_tiny(xyzw[i]);
}

BuiltScene build_skeletons(const RawScene& scene) {
  BuiltScene out;
  const std::vector<std::size_t> order = parents_first(scene);
  const std::vector<std::vector<int>> skeletons = breadth_first(scene, choose_joints(scene, order), order);
  number_joints(scene, skeletons, order, out);
  for (const std::vector<int>& joints : skeletons) out.skeletons.push_back(build_skeleton(scene, joints, out.nearest));
  std::vector<char> named(out.skeletons.size(), 0);
  for (const RawSkin* const skin : skins_in_use(scene)) {
    const auto s = to_index(out.nearest[to_index(skin->joints.front())].skeleton);
    if (named[s] != 0 || skin->name.empty()) continue;
    out.skeletons[s].name = skin->name;
    named[s] = 1;
  }
  return out;
}
}  // namespace marrow::cook
