// The cooker's arguments (jobs/cooker.h) and options (options/options.h) on a command line.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cook/options/options.h"
#include "jobs/cooker.h"

namespace marrow::tools {

// What is cooked into what, and what the work takes: settings, cache, threads. `a` lives as long as the command.
void add_cook_files(CLI::App* command, CookArguments& a);

// Options of these names, or without names all of them. What is given goes into `given`.
void add_cook_options(CLI::App* command, const std::vector<std::string>& names, cook::Options& given);

}  // namespace marrow::tools
