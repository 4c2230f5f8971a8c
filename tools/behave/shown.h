// What an animator shows by now, node by node.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/animator.h"

namespace marrow::tools {

struct ShownNode {
  std::uint32_t node = 0;
  float weight = 0;  // in the whole pose; of what a mask or an additive layer lays over it, in what it is laid over
  bool is_clip = false;
  float time_s = 0;                      // in the clip
  const Animation* animation = nullptr;  // of a clip
};

// Nodes of weight above 0 in the graph's order, with their weights in the poses of now. Empty before the first update.
// What remains of an inertial fade is no node, and not among them. Cost: once over the graph.
std::vector<ShownNode> shown_nodes(const Animator& animator);

// Whose poses a node takes, in the graph's order of them; states that show nothing are none.
std::vector<std::uint32_t> nodes_below(const Graph& graph, std::uint32_t node);

}  // namespace marrow::tools
