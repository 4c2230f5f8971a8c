// The cooker's options (options/options.h) on a command line.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "options/options.h"

namespace marrow::tools {

// Options of these names, or without names all of them. What is given goes into `given`.
void add_cook_options(CLI::App* command, const std::vector<std::string>& names, cook::Given& given);

}  // namespace marrow::tools
