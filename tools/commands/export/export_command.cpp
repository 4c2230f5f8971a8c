#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/command.h"
#include "common/files.h"
#include "common/formats.h"
#include "common/load_mrw.h"
#include "export/export.h"
#include "terminal/warnings.h"

namespace marrow::tools {

void add_export(CLI::App& app, int&) {
  static std::string in, out;  // as long as the options that point at them
  CLI::App* const command = app.add_subcommand("export", "Write a cooked file back as plain glTF 2.0");
  add_input(command, in);
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([] {
    expect_extension(out, {".glb"});
    expect_writable(out);
    const LoadedFile loaded = load_mrw(in);
    const Exported exported = export_file(loaded.file, in);
    for (const std::string& line : warning_lines(in, exported.warnings)) fmt::print(stderr, "{}\n", line);
    write_file_atomically(out, exported.glb);
  });
}

}  // namespace marrow::tools
