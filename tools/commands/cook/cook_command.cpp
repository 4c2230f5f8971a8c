#include "commands/command.h"
#include "commands/cook/run_cook.h"
#include "commands/cook_options.h"

namespace marrow::tools {

void add_cook(CLI::App& app, int& exit_code) {
  static CookArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("cook", "Cook .gltf and .glb files into .mrw files");
  command->add_option("inputs", a.inputs, "files, or folders that are searched for .gltf and .glb")
      ->required()
      ->type_name("IN");
  command
      ->add_option(
          "-o,--output", a.out,
          "the cooked file to write; for several inputs, a folder among them or a name that ends in / a folder, "
          "under which the trees below the inputs are mirrored")
      ->required()
      ->type_name("OUT.mrw|DIR/");
  command->add_option("--report", a.report, "also write a report as JSON; of several inputs a list")
      ->type_name("R.json");
  command->add_flag("--json", a.json, "print the report on stdout instead of a summary");
  command->add_option("--depfile", a.depfile, "also write what outputs were made from, for ninja and make")
      ->type_name("FILE");
  command
      ->add_option("--settings", a.settings,
                   "options from this file; without it from the nearest marrow.toml, in the input's folder or above")
      ->type_name("FILE");
  command->add_option("--cache", a.cache, "keep cooked files in this folder and cook nothing twice")
      ->envname("MARROW_CACHE")
      ->type_name("DIR");
  command->add_option("--cache-size", a.cache_bytes, "beyond it what was not used for longest is removed, as in 500MB")
      ->transform(CLI::AsSizeValue(true))
      ->default_str("1GiB")
      ->type_name("BYTES");
  command->add_option("--jobs", a.jobs, "threads; without it one a core")->check(CLI::Range(1u, 1024u))->type_name("N");
  add_cook_options(command, {}, a.given);
  command->callback([&exit_code] { exit_code = run_cook(a); });
}

}  // namespace marrow::tools
