// `marrow graph dot`: a graph as Graphviz draws it.
#pragma once

#include <string>

#include "behave/find_graph.h"

namespace marrow::tools {

// A digraph: nodes, with what they take poses of; machines with their states and what leads from one to another.
std::string dot_text(const FoundGraph& found);

}  // namespace marrow::tools
