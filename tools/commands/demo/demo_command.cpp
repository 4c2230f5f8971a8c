#include "commands/command.h"
#include "commands/demo/demo.h"

namespace marrow::tools {

void add_demo(CLI::App& app, int&) {
  static DemoArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("demo", "Cook models, draw a contact sheet of each, print a table");
  command->add_option("inputs", a.inputs, "glTF files; without one, the embedded sample")->type_name("IN.glb");
  command->add_option("--clip", a.clip, "clip by name or index; without it the one where plain skinning is worst")
      ->type_name("C");
  command->add_option("-o,--output", a.directory, "folder for NAME.mrw and NAME.png")->required()->type_name("DIR");
  command->callback([] { run_demo(a); });
}

}  // namespace marrow::tools
