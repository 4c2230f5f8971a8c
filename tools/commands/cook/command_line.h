// The command line of `marrow cook`.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "options/options.h"

namespace marrow::tools {

// Some of its options, for other commands.
void add_cook_options(CLI::App* command, const std::vector<std::string>& names, cook::Given& given);

// `exit_code` is set when the command has run.
void add_cook(CLI::App& app, int& exit_code);

}  // namespace marrow::tools
