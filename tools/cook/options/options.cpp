#include "cook/options/options.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/failure.h"
#include "cook/options/exclusions.h"
#include "cook/options/option_lists.h"

namespace marrow::cook {

const std::vector<Option>& option_table() {
  static const std::vector<Option> table = [] {
    std::vector<Option> out;
    for (const std::span<const Option> part : {clip_options(), motion_options(), precision_options(), learn_options(),
                                               mesh_options(), weight_options(), scene_options()})
      out.insert(out.end(), part.begin(), part.end());
    return out;
  }();
  return table;
}

std::string replacement_of(std::string_view name) {
  return name == "half-joints" ? "helpers took their place, give --helpers N or --helpers auto" : "";
}

void replace(Options& given, const Options& with) {
  for (const auto& [name, values] : with) given[name] = values;
}

CookOptions to_options(const Options& given) {
  CookOptions options;
  for (const Option& option : option_table()) {
    const auto found = given.find(option.name);
    if (found == given.end()) continue;
    for (const Value& value : found->second) {
      if (option.kind == OptionKind::flag && value.text != "true") continue;
      if (!option.choices.empty() && std::ranges::find(option.choices, value.text) == option.choices.end())
        refuse(value, "\"" + value.text + "\" is no " + option.name,
               fmt::format("give {}", fmt::join(option.choices, " or ")));
      option.set(options, value);
    }
  }
  if (const auto shapes = given.find(kShapes); shapes != given.end())
    for (const Value& value : shapes->second) options.shapes.push_back(*value.shape);
  // Of what blends rotations; beside delta mush helpers do not pay.
  LearnOptions& learn = options.learn;
  if (learn.animation_space == AnimationSpace::fit && !given.contains("helpers") && blends_rotations(learn.truth))
    learn.helpers = kAutoHelpers;
  check_together(options, given);
  return options;
}

CookOptions to_graph_options(const Options& given) {
  for (const auto& [name, values] : given)
    if (name != "graph")
      throw tools::Failure(tools::Exit::usage, "--" + name, "", "graphs without a model",
                           "name a model, or leave it out");
  CookOptions options = to_options(given);
  if (options.graphs.empty())
    throw tools::Failure(tools::Exit::usage, "--graph", "", "no graph", "name one, as in hero.anim.toml");
  return options;
}

std::string canonical_text(const Options& given) {
  std::string out;
  for (const auto& [name, values] : given) {
    for (const Value& value : values)
      out +=
          name + " " + std::to_string(value.text.size()) + " " + value.text + (value.origin.must_fit ? " !\n" : "\n");
  }
  return out;
}

}  // namespace marrow::cook
