// The command line of `marrow cook`.
#pragma once

#include <CLI/CLI.hpp>

namespace marrow::tools {

// `exit_code` is set when the command has run.
void add_cook(CLI::App& app, int& exit_code);

}  // namespace marrow::tools
