// `marrow sample`: the embedded character as a file.
#include "commands/command.h"
#include "common/formats.h"
#include "disk/files.h"
#include "sample/embedded.h"

namespace marrow::tools {

void add_sample(CLI::App& app, int&) {
  static std::string out;  // as long as the options that point at it
  static bool moves = false, graph = false;
  CLI::App* const command = app.add_subcommand("sample", "Write the embedded sample character as a .glb file");
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  CLI::Option* const of_moves = command->add_flag(
      "--moves", moves, "clips for a game, without meshes: run, jump, land, turn, stop, hit and more");
  command->add_flag("--graph", graph, "its behaviour by those clips, as OUT.anim.toml")->excludes(of_moves);
  command->callback([] {
    expect_extension(out, {graph ? ".toml" : ".glb"});
    write_file_atomically(out, graph ? sample_graph() : moves ? sample_moves_glb() : sample_glb());
  });
}

}  // namespace marrow::tools
