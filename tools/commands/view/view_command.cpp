#include "commands/command.h"
#include "commands/look_arguments.h"
#include "commands/view/view.h"

namespace marrow::tools {

void add_view(CLI::App& app, int&) {
  static ViewArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("view", "Show a character in a window, with a panel for all of it");
  add_look(command, a, kPosedPaths);
  command->add_flag("--bones", a.bones, "draw the skeleton over it");
  command->add_option("--weights", a.weights, "colour the weights of this joint")
      ->type_name("JOINT")
      ->excludes("--heatmap");
  CLI::Option* const screenshot =
      command->add_option("--screenshot", a.screenshot, "write the window's picture after some frames, and end")
          ->type_name("P.png");
  command->add_option("--frames", a.frames, "after so many, each a sixtieth of a second")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str()
      ->needs(screenshot);
  command->footer("What the options choose is where the panel begins. With --time the clip is paused there.");
  command->callback([command] {
    a.held = command->count("--time") > 0;
    run_view(a);
  });
}

}  // namespace marrow::tools
