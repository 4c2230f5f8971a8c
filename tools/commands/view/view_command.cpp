#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/look_arguments.h"
#include "commands/view/view.h"
#include "stage/settings.h"

namespace marrow::tools {

void add_view(CLI::App& app, int&) {
  static ViewArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("view", "Show a character in a window, with a panel for all of it");
  add_look(command, a, kPosedPaths, kGpuDeformers);
  command->get_option("file")->description("the cooked file, or glTF, which is cooked in memory");
  add_reach(command, a.reach);
  command->add_flag("--bones", a.bones, "draw the skeleton over it, as --show bones");
  std::vector<std::string> shown{"uv"};
  for (const auto& [name, flag] : kOverlays) shown.emplace_back(name);
  command
      ->add_option(
          "--show", a.show,
          "what is drawn with it, separated by commas: bones, names and axes of joints, the trail of --joint "
          "over the clip, steps of the feet and the root's path, a ground grid, wireframe, normals, a checker by UV")
      ->type_name("WHAT,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(shown));
  command->add_option("--ghosts", a.ghosts, "so many poses before and after, see-through")
      ->type_name("N")
      ->check(CLI::Range(0, 4));
  command->add_option("--joint", a.joint, "choose this joint: its transforms and curves")->type_name("JOINT");
  command->add_flag("--springs", a.springs, "the file's springs swing; where it has none, the joints below --joint");
  command->add_flag("--limits", a.limits, "keep joints within the file's limits");
  command->add_option("--weights", a.weights, "colour the weights of this joint")
      ->type_name("JOINT")
      ->excludes("--heatmap");
  command
      ->add_option("--paint", a.paint_file,
                   "paint the weights of --weights or --joint; they are saved to this file, which marrow cook --paint "
                   "reads; without a file, to FILE.paint.json beside the character's")
      ->type_name("P.json")
      ->expected(0, 1);
  CLI::Option* const screenshot =
      command->add_option("--screenshot", a.screenshot, "write the window's picture after some frames, and end")
          ->type_name("P.png");
  command->add_option("--frames", a.frames, "after so many, each a sixtieth of a second")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str()
      ->needs(screenshot);
  add_graph(command, a);
  command->footer(
      "What the options choose is where the panel begins. With --time the clip is paused there. A .gltf, .glb or .vrm "
      "file is cooked in memory, by the nearest marrow.toml. What changes on the disk is loaded again, and what is "
      "dropped on the window is opened; an error is shown in the window until the next good save. By a graph, "
      "1 to 9 fire, set or choose a parameter, up and down change the chosen number, left and right go a frame back "
      "and "
      "on, with Ctrl ten. While painting, the "
      "left button paints on the figure and turns the camera beside it, or with Ctrl; [ and ] make the brush smaller "
      "and larger, Ctrl Z and Ctrl Y undo and redo, Ctrl S saves.");
  command->callback([command] {
    a.held = command->count("--time") > 0;
    a.paints = command->count("--paint") > 0;
    take_graph(*command, {"--clip", "--time", "--ik", "--ghosts", "--paint"}, a);
    run_view(a);
  });
}

}  // namespace marrow::tools
