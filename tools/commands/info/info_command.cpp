#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/info/info.h"

namespace marrow::tools {

void add_info(CLI::App& app, int&) {
  static InfoArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("info", "Say what a cooked file holds, and what its vertices cost phones' GPUs");
  add_input(command, a.in);
  command->add_option("--source", a.source, "the glTF file it was cooked from, to show its bytes beside")
      ->type_name("IN.glb");
  command->add_flag("--json", a.json, "as JSON");
  command->callback([] { run_info(a); });
}

}  // namespace marrow::tools
