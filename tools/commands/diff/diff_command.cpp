#include "commands/command.h"
#include "commands/diff/diff.h"

namespace marrow::tools {

void add_diff(CLI::App& app, int& exit_code) {
  static DiffArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("diff", "Say in what two cooked files differ");
  command->add_option("a", a.a, "a cooked file")->required()->type_name("A.mrw");
  command->add_option("b", a.b, "another")->required()->type_name("B.mrw");
  command
      ->add_option("--skeleton", a.skeleton, "of two clip packs: the character that they move, to measure poses on it")
      ->type_name("CHARACTER.mrw");
  command->add_flag("--json", a.json, "as JSON: {equal, differences: [{kind, in, text, ...}]}");
  command->footer("Exit codes: 0 the same bytes, 6 they differ, others as ever.");
  command->callback([&exit_code] { exit_code = run_diff(a) ? 0 : kFilesDiffer; });
}

}  // namespace marrow::tools
