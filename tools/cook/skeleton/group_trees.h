// Which trees of joints are one skeleton: what a skin or a clip ties together.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/scene/raw.h"

namespace marrow::cook {

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
