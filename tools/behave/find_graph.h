// The graph that a command line names: of the character's file, of a graph pack, or a text.
#pragma once

#include <string>
#include <vector>

#include "behave/graphs.h"

namespace marrow::tools {

// What a command line says of how a character behaves.
struct BehaviourArguments {
  std::string graph;               // as find_graph() takes it
  std::vector<std::string> clips;  // packs, as Behaviour takes them
};

// wanted: empty or NAME, a graph of `file`, loaded from `path`; FILE.toml, a text that is cooked now; PACK.mrw or
// NAME@PACK.mrw, of another cooked file. Throws Failure, also what loading and cooking throw.
FoundGraph find_graph(const std::string& path, const File& file, const std::string& wanted);

// A text that is in memory. path: what it is called.
FoundGraph cook_graph_text(const std::string& path, const std::string& text);

// The graph of a text or a cooked file that is named alone. wanted: of several. Throws likewise.
FoundGraph open_graph(const std::string& path, const std::string& wanted = "");

}  // namespace marrow::tools
