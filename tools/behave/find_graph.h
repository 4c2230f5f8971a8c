// The graph that a command line names: of the character's file, of a graph pack, or a text.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "marrow/graph.h"

namespace marrow::tools {

struct FoundGraph {
  std::string path;  // of the file or the text that has it
  File file;         // whose names it has
  Graph graph;
  std::vector<std::string> warnings;         // of a text
  std::shared_ptr<const LoadedFile> memory;  // of a file that was opened for it
};

// All graphs of a file, in its order. Throws Failure (invalid) if one is damaged.
std::vector<Graph> graphs_of(const std::string& path, const File& file);

// A graph by its name or number; without either the only one of the file. Throws Failure (usage) that lists what there
// is.
Graph named_graph(const std::string& path, const File& file, const std::string& wanted);

// wanted: empty or NAME, a graph of `file`, loaded from `path`; FILE.toml, a text that is cooked now; PACK.mrw or
// NAME@PACK.mrw, of another cooked file. Throws Failure, also what loading and cooking throw.
FoundGraph find_graph(const std::string& path, const File& file, const std::string& wanted);

// A text that is in memory. path: what it is called.
FoundGraph cook_graph_text(const std::string& path, const std::string& text);

// The graph of a text or a cooked file that is named alone. wanted: of several. Throws likewise.
FoundGraph open_graph(const std::string& path, const std::string& wanted = "");

}  // namespace marrow::tools
