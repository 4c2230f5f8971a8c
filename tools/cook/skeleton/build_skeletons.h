// Which nodes become joints of which skeleton. A joint is a node that a skin names, that a clip moves, that a game
// or springs move, that lies between two such nodes, or that carries a mesh with nothing of the kind above it. Nodes
// above the joints never move: their product is kept a root.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// A scene of nothing but skeletons, without limits, and of where each node went. Throws tools::Failure (unsupported)
// for too many joints.
BuiltScene build_skeletons(const RawScene& scene);

// Which joints hang on which, each asked in O(1). Parents come before their children.
class Descent {
 public:
  explicit Descent(const std::vector<std::uint16_t>& parents = {});
  // Itself, or somewhere above.
  bool is_at_or_above(int above, int joint) const {
    const std::uint32_t at = first_[to_index(joint)];
    return at >= first_[to_index(above)] && at < end_[to_index(above)];
  }

 private:
  std::vector<std::uint32_t> first_, end_;  // of a joint and all below it, in a walk that goes down first
};

// Those of a skeleton.
std::vector<Mesh> meshes_of(const std::vector<Mesh>& meshes, std::size_t skeleton);

// For whoever makes skeletons otherwise.

// Four joints that are not there.
inline constexpr SoaTransform kRestOfNone = {
    {}, {{}, {}, {}, {1, 1, 1, 1}}, {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};

// Every node after its parent.
std::vector<std::size_t> parents_first(const RawScene& scene);

// A node: 1 if a skin in use names it or a clip moves it.
std::vector<char> named_or_moved(const RawScene& scene);

// A node that is no joint, whose parent has its place already.
void place_below_parent(const RawScene& scene, std::size_t node, std::vector<NearestJoint>& nearest);

// The joint stands at rest as the node does.
void set_rest(const RawNode& node, std::size_t joint, BuiltSkeleton& skeleton);

// The skins that count: those that a mesh is drawn with; in a file that draws nothing, all whose joints are in the
// scene.
std::vector<const RawSkin*> skins_in_use(const RawScene& scene);

// The node whose joint decides which skeleton a morph target's weight belongs to: of the skin of its mesh, else its
// own.
int node_of_weights(const RawScene& scene, int mesh_node);

// tree_of_node: the tree of the joint at or above each node; kNone: none. trees: how many there are.
// Returns for each tree the number of its skeleton. Skeletons count from 0: first those with a skin, then others that
// clips move, last one of everything that nothing touches; of a kind in the order of their first trees.
std::vector<std::size_t> group_trees(const RawScene& scene, const std::vector<int>& tree_of_node, std::size_t trees);

}  // namespace marrow::cook
