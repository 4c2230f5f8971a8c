#include "commands/cook_options.h"

#include <algorithm>

namespace marrow::tools {
namespace {

// One option of the table, as on the command line.
void add_option(CLI::App* command, const cook::Option& option, cook::Options& given) {
  const std::string flag = std::string("--") + option.name;
  const auto value_of = [flag](const std::string& text) { return cook::Value{text, {flag, ""}}; };
  if (option.kind == cook::OptionKind::flag) {
    command->add_flag_function(
        flag,
        [&given, &option, value_of](std::int64_t n) { given[option.name] = {value_of(n > 0 ? "true" : "false")}; },
        option.help);
    return;
  }
  const auto take = [&given, &option, value_of](const std::vector<std::string>& texts) {
    std::vector<cook::Value>& values = given[option.name];
    values.clear();
    for (const std::string& text : texts) values.push_back(value_of(text));
  };
  CLI::Option* const added = command->add_option_function<std::vector<std::string>>(flag, take, option.help);
  added->type_name(option.shape)->allow_extra_args(false);
  if (option.kind == cook::OptionKind::list || option.kind == cook::OptionKind::table) {
    added->take_all();
  } else {
    added->take_last()->expected(1);
  }
  if (!option.choices.empty())
    added->check(CLI::IsMember(std::vector<std::string>(option.choices.begin(), option.choices.end())))
        ->default_str(option.choices.front());
}

}  // namespace

void add_cook_files(CLI::App* command, CookArguments& a) {
  command->add_option("inputs", a.inputs, "files, or folders that are searched for .gltf, .glb, .vrm and .bvh")
      ->required()
      ->type_name("IN");
  command
      ->add_option("-o,--output", a.out,
                   "the cooked file to write; for several inputs, a folder among them, a folder that is there or a "
                   "name that ends in / a folder, under which the trees below the inputs are mirrored")
      ->required()
      ->type_name("OUT.mrw|DIR/");
  command
      ->add_option("--settings", a.settings,
                   "options from this file; without it from the nearest marrow.toml, in the input's folder or above")
      ->type_name("FILE");
  command
      ->add_option("--cache", a.cache.places,
                   "keep cooked files in this folder, or on this server, and cook nothing twice; again for another "
                   "place, which is asked where those before have nothing")
      ->envname("MARROW_CACHE")
      ->allow_extra_args(false)
      ->type_name("DIR|http://…");
  command
      ->add_option("--cache-size", a.cache.folder_bytes,
                   "of a folder: beyond it what was not used for longest is removed, as in 500MB")
      ->transform(CLI::AsSizeValue(true))
      ->default_str("1GiB")
      ->type_name("BYTES");
  command->add_flag("--cache-read-only", a.cache.read_only, "keep nothing on servers");
  command->add_option("--cache-token", a.cache.token_file, "servers are told who asks by the first line of this file")
      ->type_name("FILE");
  command->add_option("--cache-timeout", a.cache.timeout_s, "how long a server may take for an entry")
      ->check(CLI::Range(1u, 3600u))
      ->default_str("10")
      ->type_name("SECONDS");
  command->add_option("--jobs", a.jobs, "threads; without it one a core")->check(CLI::Range(1u, 1024u))->type_name("N");
}

void add_cook_options(CLI::App* command, const std::vector<std::string>& names, cook::Options& given) {
  for (const cook::Option& option : cook::option_table())
    if (names.empty() || std::ranges::find(names, option.name) != names.end()) add_option(command, option, given);
}

}  // namespace marrow::tools
