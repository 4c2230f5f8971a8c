#include "commands/cook_options.h"

#include <algorithm>

namespace marrow::tools {
namespace {

// One option of the table, as on the command line.
void add_option(CLI::App* command, const cook::Option& option, cook::Given& given) {
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
  if (option.kind == cook::OptionKind::list) {
    added->take_all();
  } else {
    added->take_last()->expected(1);
  }
  if (!option.choices.empty())
    added->check(CLI::IsMember(std::vector<std::string>(option.choices.begin(), option.choices.end())))
        ->default_str(option.choices.front());
}

}  // namespace

void add_cook_options(CLI::App* command, const std::vector<std::string>& names, cook::Given& given) {
  for (const cook::Option& option : cook::option_table())
    if (names.empty() || std::ranges::find(names, option.name) != names.end()) add_option(command, option, given);
}

}  // namespace marrow::tools
