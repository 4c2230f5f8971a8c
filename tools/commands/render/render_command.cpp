#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/look_arguments.h"
#include "commands/render/movie.h"
#include "commands/render/render.h"

namespace marrow::tools {
namespace {

void add_movie(CLI::App* command, RenderArguments& a) {
  CLI::Option* const movie =
      command->add_flag("--movie", a.movie,
                        "a moving picture that loops: the clip, or with --time, or of what does not move, a turntable; "
                        "an animated PNG (.png), or by the program ffmpeg .gif, .mp4 or .webm, or, with -o FOLDER/ or "
                        "-o NAME%04d.png, numbered frames; without --size one .png or .gif has 480x360");
  command->add_option("--fps", a.fps, "frames a second of a movie")
      ->type_name("N")
      ->check(CLI::Range(1, 60))
      ->capture_default_str()
      ->needs(movie);
  command
      ->add_option("--turn", a.turn_deg,
                   "degrees that the camera and the lights walk round the character over the movie, at most 60 a "
                   "second: a shorter clip is repeated; a turntable's default is 360")
      ->type_name("DEGREES")
      ->check(finite("degrees"))
      ->check(CLI::Range(-3600.0f, 3600.0f))
      ->needs(movie);
}

void add_viewpoint(CLI::App* command, ViewpointArguments& a) {
  add_one_of(command, "--view", kSides, a.side,
             "the side that is seen of a character that faces +Z; left and right are its own");
  CLI::Option* const joint =
      command->add_option("--look-at", a.look_at, "aim at the place of a joint, and follow it")->type_name("JOINT");
  command
      ->add_option("--distance", a.distance,
                   "from the joint to the camera, metres or as in 50cm; without it half of the character's size")
      ->type_name("LENGTH")
      ->needs(joint);
}

}  // namespace

void add_render(CLI::App& app, int&) {
  static RenderArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("render", "Draw a character at a moment of a clip, or a movie");
  add_look(command, a, kSkinPaths);
  add_outfits(command, a.outfits);
  add_reach(command, a.reach);
  add_between(command, a.between);
  add_viewpoint(command, a.viewpoint);
  command->add_flag("--springs", a.springs, "the file's springs swing as the clip moves them, from its beginning on");
  add_movie(command, a);
  command->add_option("-o,--output", a.output, "the picture, PNG, or the movie")->required()->type_name("P.png");
  command->callback([command] {
    a.held = command->count("--time") > 0;
    if (a.movie && command->count("--size") == 0) a.size = default_movie_size(a.output);
    run_render(a);
  });
}

}  // namespace marrow::tools
