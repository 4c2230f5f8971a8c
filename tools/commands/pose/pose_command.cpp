#include "commands/arguments.h"
#include "commands/between.h"
#include "commands/command.h"
#include "commands/pose/write_pose.h"

namespace marrow::tools {

void add_pose(CLI::App& app, int&) {
  static PoseArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("pose", "Write a character's vertices at a moment of a clip");
  add_input(command, a.in);
  add_outfits(command, a.outfits);
  add_choice(command, a.choice);
  add_between(command, a.between);
  add_deformer(command, a.deformer);
  command
      ->add_option("-o,--output", a.out, "P.bin: little-endian float32 x y z a vertex, model space; P.obj: Wavefront")
      ->required()
      ->type_name("P.obj|P.bin");
  command->callback([] { run_pose(a); });
}

}  // namespace marrow::tools
