// Arguments that several sub-commands have.
#pragma once

#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "pose/choose.h"
#include "text/choices.h"

namespace marrow::tools {

void add_input(CLI::App* command, std::string& to);
// Files that the character wears, behind it.
void add_outfits(CLI::App* command, std::vector<std::string>& to);

// --clip and --clips. without: what happens without a clip.
void add_clip(CLI::App* command, Choice& choice, const std::string& without);
// These, --time and --set.
void add_choice(CLI::App* command, Choice& choice);
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
