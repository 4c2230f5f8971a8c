// What a command line says of a graph that a character goes by.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "behave/behaviour.h"
#include "commands/command.h"
#include "pose/choose.h"

namespace marrow::tools {

// As it is given.
struct GraphOptions {
  std::string graph;
  std::vector<std::string> packs;
};

// --graph, and in place of add_look()'s --clips, which takes one pack, one that takes several. Returns the first.
CLI::Option* add_graph(CLI::App* command, GraphOptions& options);

// What is meant by them; nothing without --graph: then the pack is the choice's. Throws Failure (usage): of options
// that do not go with a graph, of several packs without one.
std::optional<BehaviourArguments> graph_of(const CLI::App& command, const GraphOptions& given,
                                           std::initializer_list<const char*> others, Choice& choice);

}  // namespace marrow::tools
