// The sub-commands of `marrow`. Each has a file NAME_command.cpp, here or in a folder of its own, that declares its
// command line.
#pragma once

#include <CLI/CLI.hpp>

namespace marrow::tools {

// Adds a sub-command to the program, with what it does when it is called. `exit_code` is the process's, 0 before.
using AddCommand = void (*)(CLI::App& app, int& exit_code);

void add_cook(CLI::App& app, int& exit_code);
void add_watch(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_retarget(CLI::App& app, int& exit_code);
void add_graph(CLI::App& app, int& exit_code);
void add_info(CLI::App& app, int& exit_code);
void add_pose(CLI::App& app, int& exit_code);
void add_sample(CLI::App& app, int& exit_code);
// With MARROW_HAS_ALL_COMMANDS.
void add_bench(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_diff(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
// With MARROW_HAS_GLES.
void add_render(CLI::App& app, int& exit_code);
void add_demo(CLI::App& app, int& exit_code);
// With MARROW_HAS_VIEW.
void add_view(CLI::App& app, int& exit_code);

}  // namespace marrow::tools
