#include "commands/command.h"
#include "commands/cook/run_cook.h"
#include "commands/cook_options.h"

namespace marrow::tools {

namespace {

ShareOfWork part;

// Work that several machines share.
void add_part(CLI::App* command) {
  CLI::Option* const plan = command
                                ->add_option("--plan", part.plan,
                                             "cook nothing: list what is to cook, with what it needs and may take, "
                                             "the longest first")
                                ->type_name("PLAN.json");
  for (const char* other : {"--report", "--json", "--depfile"}) plan->excludes(other);
  command
      ->add_option_function<std::string>(
          "--shard", [](const std::string& text) { part.shard = read_shard(text); },
          "cook one of N shares, which take about as long; together they cook all")
      ->type_name("I/N")
      ->excludes(plan);
  command
      ->add_flag("--fits", part.fits,
                 "cook nothing: learn for meshes, each by itself, into --cache, where cooking finds it")
      ->needs("--cache")
      ->excludes(plan)
      ->excludes("--report")
      ->excludes("--json")
      ->excludes("--depfile");
  command->add_option("--history", part.history, "reports of before, which say what takes how long")
      ->allow_extra_args(false)
      ->type_name("R.json");
  command->add_option("--program", part.program, "refuse unless this program is the plan's")->type_name("HASH");
}

}  // namespace

void add_cook(CLI::App& app, int& exit_code) {
  static CookArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("cook", "Cook .gltf, .glb, .vrm and .bvh files into .mrw files");
  add_cook_files(command, a);
  command->add_option("--report", a.report, "also write a report as JSON; of several inputs a list")
      ->type_name("R.json");
  command->add_flag("--json", a.json, "print the report on stdout instead of a summary");
  command->add_option("--depfile", a.depfile, "also write what outputs were made from, for ninja and make")
      ->type_name("FILE");
  add_part(command);
  add_cook_options(command, {}, a.given);
  command->get_option("inputs")->required(false);
  command->callback([&exit_code, command] {
    // Graphs alone need no model.
    part.is_given = part.fits || !part.plan.empty() || command->count("--shard") > 0;
    if (a.inputs.empty() && (part.is_given || !a.given.contains("graph"))) throw CLI::RequiredError("inputs");
    exit_code = a.inputs.empty() ? cook_graph_pack(a) : run_cook(a, part);
  });
}

}  // namespace marrow::tools
