// The rules of graph.h: what File::graph() and bind_graph() ask.
#pragma once

#include "marrow/graph.h"

namespace marrow {

// A broken rule, and the record that breaks it; null: it is about the graph as a whole.
struct GraphFault {
  const void* where = nullptr;
  const char* rule = nullptr;  // null: all is well
};

// The first broken rule. The spans hold what they say.
GraphFault find_fault(const Graph& graph);

// How many poses are held at once to make a node's; of a graph whose nodes stand in their order.
std::uint32_t poses_of(const Graph& graph, std::uint32_t node);

}  // namespace marrow
