#include "commands/graph_arguments.h"

#include "common/failure.h"

namespace marrow::tools {

CLI::Option* add_graph(CLI::App* command, GraphOptions& options) {
  command->remove_option(command->get_option("--clips"));
  command
      ->add_option("--clips", options.packs,
                   "take clips from this clip pack; for --graph it may be given several times")
      ->type_name("PACK.mrw")
      ->allow_extra_args(false);
  return command
      ->add_option("--graph", options.graph,
                   "the character goes by a graph of behaviour: one of the file by name, without it the only one; "
                   "a text, which is cooked now; or of a graph pack, NAME@PACK.mrw where it has several. A model "
                   "(.glb and others) is cooked as well, with --root '*=ground'")
      ->type_name("[NAME|FILE.toml|PACK.mrw]")
      ->expected(0, 1);
}

std::optional<BehaviourArguments> graph_of(const CLI::App& command, const GraphOptions& given,
                                           std::initializer_list<const char*> others, Choice& choice) {
  const bool goes = command.count("--graph") > 0;
  if (!goes && given.packs.size() > 1)
    throw Failure(Exit::usage, "--clips", "", "several packs", "a clip comes from one; --graph takes several");
  choice.clips = goes || given.packs.empty() ? "" : given.packs[0];
  if (!goes) return std::nullopt;
  for (const char* const other : others)
    if (command.count(other) > 0)
      throw Failure(Exit::usage, other, "", "a character that goes by a graph", "leave it out, or --graph");
  return BehaviourArguments{given.graph, given.packs};
}

}  // namespace marrow::tools
