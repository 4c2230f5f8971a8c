#include "commands/command.h"
#include "common/files.h"
#include "common/formats.h"
#include "sample/embedded.h"

namespace marrow::tools {

void add_sample(CLI::App& app, int&) {
  static std::string out;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("sample", "Write the embedded sample character as a .glb file");
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([] {
    expect_extension(out, {".glb"});
    write_file_atomically(out, sample_glb());
  });
}

}  // namespace marrow::tools
