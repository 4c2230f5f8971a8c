#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/info/info.h"

namespace marrow::tools {

void add_info(CLI::App& app, int&) {
  static InfoArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("info", "Say what cooked files hold, and what its vertices cost phones' GPUs");
  command->add_option("file", a.in, "cooked files")->required()->type_name("FILE...");
  command->add_option("--source", a.source, "the glTF file it was cooked from, to show its bytes beside")
      ->type_name("IN.glb");
  command->add_flag("--roles", a.roles, "only what joints are for, which mirror each other, and where feet stand");
  command->add_flag("--motion", a.motion, "only what clips do: their speeds, events, steps, and how their roots move");
  command->add_flag("--json", a.json, "as JSON; of several files as an array");
  command->callback([] { run_info(a); });
}

}  // namespace marrow::tools
