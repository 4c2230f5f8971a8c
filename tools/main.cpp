// The program `marrow`: the table of its sub-commands, and the one place where failures become exit codes.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands/command.h"
#include "common/failure.h"
#include "cook/options/options.h"
#include "disk/thread_pool.h"
#include "marrow/call_error.h"
#include "terminal/interrupt.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

// In the order of --help.
constexpr AddCommand kCommands[] = {
    add_cook,   add_watch,   add_report, add_retarget, add_graph, add_info,
#ifdef MARROW_HAS_ALL_COMMANDS
    add_diff,   add_export,
#endif
    add_pose,
#ifdef MARROW_HAS_ALL_COMMANDS
    add_bench,  add_compare,
#endif
    add_sample,
#ifdef MARROW_HAS_GLES
    add_render, add_demo,
#endif
#ifdef MARROW_HAS_VIEW
    add_view,
#endif
};

// A bad call of the runtime is the tools' own error.
void print_call_error(const char* function, const char* condition) {
  std::fprintf(stderr, "marrow: bad call of %s: %s\n", function, condition);
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> out;
  for (const CLI::Option* const option : command.get_options())
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
  return out;
}

std::vector<std::string> command_names(CLI::App& app) {
  std::vector<std::string> out;
  for (const CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; }))
    out.push_back(command->get_name());
  return out;
}

// A word that means nothing explains more than what is missing without it.
std::string explain(CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const std::string help = "see marrow " + (commands.empty() ? "" : command.get_name() + " ") + "--help";
  for (const std::string& text : command.remaining()) {
    const std::string word = text.substr(0, text.find('='));
    if (word.starts_with("-")) {
      const std::string now = cook::replacement_of(word.starts_with("--") ? word.substr(2) : word);
      const std::string question = now.empty() ? did_you_mean(word, option_names(command)) : now;
      return "unknown option " + printable(word) + (question.empty() ? "" : ": " + question) + " (" + help + ")";
    }
    if (commands.empty()) return "no command \"" + printable(word) + "\": " + suggestion(word, command_names(app));
  }
  return std::string(error.what()) + " (" + help + ")";
}

int run(int argc, char** argv) {
  CLI::App app{"Marrow: skeletal animation, from glTF to pixels.", "marrow"};
  app.require_subcommand(1);
  app.set_version_flag("--version", MARROW_VERSION);
  app.footer(
      "Results go to stdout, everything else to stderr.\n"
      "Exit codes: 0 done, 1 usage, 2 input/output, 3 invalid input, 4 unsupported, 5 internal, "
      "6 files differ (diff), 130 interrupted.");
  int exit_code = 0;
  for (const AddCommand add : kCommands) add(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    std::fprintf(stderr, "marrow: %s\n", explain(app, e).c_str());
    return static_cast<int>(Exit::usage);
  }
  return exit_code;
}

// Libraries under the tools are not to be trusted with std::bad_alloc (a destructor of nlohmann::json's asks for
// memory, another follows a null pointer): where memory ends, so does the program. Its files are whole or as they were.
[[noreturn]] void end_without_memory() {
  std::fputs("marrow: out of memory\n", stderr);
  std::_Exit(static_cast<int>(Exit::internal));
}

}  // namespace
}  // namespace marrow::tools

int main(int argc, char** argv) {
  using marrow::tools::Exit;
  std::set_new_handler(marrow::tools::end_without_memory);
  try {
    marrow::tools::end_cleanly_on_interrupt();
    marrow::set_call_error_handler(marrow::tools::print_call_error);
    const marrow::tools::UseWork work({&marrow::tools::all_cores(), nullptr});
    const int code = marrow::tools::run(argc, argv);
    // What a pipe or a full disk refuses is known when everything has been handed over.
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    throw marrow::tools::Failure(Exit::io, "stdout", "", "cannot write", std::strerror(errno));
  } catch (const marrow::tools::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(failure.code());
  } catch (const std::bad_alloc&) {
    std::fputs("marrow: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "marrow: internal error: %s\n", e.what());
  }
  return static_cast<int>(Exit::internal);
}
