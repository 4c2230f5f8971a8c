// The graphs of a cooked file.
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
  std::vector<std::string> warnings = {};              // of a text
  std::shared_ptr<const LoadedFile> memory = nullptr;  // of a file that was opened for it
  std::string text = {};                               // that it was cooked from; empty: it was in a cooked file
};

// All graphs of a file, in its order. Throws Failure (invalid) if one is damaged.
std::vector<Graph> graphs_of(const std::string& path, const File& file);

// A graph by its name or number; without either the only one of the file. Throws Failure (usage) that lists what there
// is.
Graph named_graph(const std::string& path, const File& file, const std::string& wanted);

}  // namespace marrow::tools
