#include "commands/command.h"
#include "commands/cook/run_cook.h"
#include "commands/cook_options.h"

namespace marrow::tools {

void add_cook(CLI::App& app, int& exit_code) {
  static CookArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("cook", "Cook .gltf, .glb, .vrm and .bvh files into .mrw files");
  add_cook_files(command, a);
  command->add_option("--report", a.report, "also write a report as JSON; of several inputs a list")
      ->type_name("R.json");
  command->add_flag("--json", a.json, "print the report on stdout instead of a summary");
  command->add_option("--depfile", a.depfile, "also write what outputs were made from, for ninja and make")
      ->type_name("FILE");
  add_cook_options(command, {}, a.given);
  command->get_option("inputs")->required(false);
  command->callback([&exit_code] {
    // Graphs alone need no model.
    if (a.inputs.empty() && !a.given.contains("graph")) throw CLI::RequiredError("inputs");
    exit_code = a.inputs.empty() ? cook_graph_pack(a) : run_cook(a);
  });
}

}  // namespace marrow::tools
