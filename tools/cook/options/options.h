// The cooker's options: one table that the command line and marrow.toml share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cook/scene/cook_options.h"
#include "marrow/cook.h"

namespace marrow::cook {

// What only marrow.toml has: [[shapes]].
inline constexpr const char* kShapes = "shapes";

enum class OptionKind {
  flag,   // given or not
  text,   // one value, the last given
  list,   // any number of values
  table,  // any number of NAME=TEXT; in marrow.toml a table
};

struct Option {
  const char* name;  // "clip-error": --clip-error on the command line, clip-error in marrow.toml
  OptionKind kind;
  const char* shape;  // of a value, as --help prints it: "[JOINT=]E"
  const char* help;
  std::span<const char* const> choices;  // of a text; the first is the default; empty: any
  // Takes one value, of a flag "true" only. Throws tools::Failure (usage) at the value's origin.
  void (*set)(CookOptions& options, const Value& value);
};

// In the order of --help. A new option is one more entry of a list, in the files beside this one.
const std::vector<Option>& option_table();

// What to give instead of an option that there was once, as advice; empty for all other names.
std::string replacement_of(std::string_view name);

// An option that is given again is replaced whole, with all its values.
void replace(Options& given, const Options& with);

// Throws tools::Failure (usage) at the origin of a wrong value.
CookOptions to_options(const Options& given);
// The same for a graph pack, which has graphs and no other option.
CookOptions to_graph_options(const Options& given);

// The same for the same options, whatever they were given by.
std::string canonical_text(const Options& given);

}  // namespace marrow::cook
