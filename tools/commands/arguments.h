// Arguments that several sub-commands have.
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "open/open_model.h"
#include "text/choices.h"

namespace marrow::tools {

// What a command line says of a model (open/open_model.h). Call those that the command has, in the order of its help.

// The file itself.
void add_input(CLI::App* command, ModelArguments& to);
// Files that the character wears, behind it.
void add_outfits(CLI::App* command, ModelArguments& to);
// --clip and --clips. without: what happens without a clip.
void add_clip(CLI::App* command, ModelArguments& to, const std::string& without);
// These, --time and --set.
void add_choice(CLI::App* command, ModelArguments& to);
// --lod.
void add_level(CLI::App* command, ModelArguments& to);
// --graph, and in place of add_clip()'s --clips, which takes one pack, one that takes several. Returns the first.
CLI::Option* add_graph(CLI::App* command, ModelArguments& to);
// Once the line is read, of a command that has add_graph(): whether it goes by a graph, and what --clips is for. Throws
// Failure (usage): of the options `others`, which do not go with a graph, of several packs without one.
void take_graph(const CLI::App& command, std::initializer_list<const char*> others, ModelArguments& to);

// What others have, too.

void add_deformer(CLI::App* command, Deformer& to, std::span<const Named<Deformer>> deformers = kDeformers);

// For CLI::Option::check.
CLI::Validator finite(const std::string& unit);

// An option that takes one of the names of `table` (text/choices.h) and sets `to`, whose value is the default. What
// the table views must outlive the command.
template <class Table, class Value>
CLI::Option* add_one_of(CLI::App* command, const std::string& name, const Table& table, Value& to,
                        const std::string& help) {
  const auto set = [view = std::span(table), &to](const std::string& text) {
    if (const auto value = value_of(view, text)) to = *value;
  };
  return command->add_option_function<std::string>(name, set, help)
      ->check(CLI::IsMember(names_of(table)))
      ->default_str(name_of(table, to));
}

}  // namespace marrow::tools
