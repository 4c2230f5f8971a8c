// The program `marrow`: one sub-command a folder, one place where failures become exit codes.
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>

#include "common/failure.h"
#include "cook/command.h"
#include "info/info.h"
#include "pose/pose.h"
#include "sample/sample.h"
#ifdef MARROW_HAS_GLES
#include "demo/demo.h"
#include "render/render.h"
#endif

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Marrow: skeletal animation, from glTF to pixels.", "marrow"};
  app.require_subcommand(1);
  app.footer(
      "Results go to stdout, everything else to stderr.\n"
      "Exit codes: 0 done, 1 usage, 2 input/output, 3 invalid input, 4 unsupported, 5 internal.");
  marrow::tools::add_cook(app);
  marrow::tools::add_info(app);
  marrow::tools::add_pose(app);
  marrow::tools::add_sample(app);
#ifdef MARROW_HAS_GLES
  marrow::tools::add_render(app);
  marrow::tools::add_demo(app);
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::fputs(app.help().c_str(), stdout);
    return 0;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help of a sub-command
    std::fprintf(stderr, "marrow: %s (see --help)\n", e.what());
    return static_cast<int>(marrow::tools::Exit::usage);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const marrow::tools::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(failure.code());
  } catch (const std::bad_alloc&) {
    std::fputs("marrow: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "marrow: internal error: %s\n", e.what());
  }
  return static_cast<int>(marrow::tools::Exit::internal);
}
