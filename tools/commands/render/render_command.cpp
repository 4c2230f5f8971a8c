#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/graph_arguments.h"
#include "commands/look_arguments.h"
#include "commands/render/movie.h"
#include "commands/render/render.h"
#include "common/failure.h"

namespace marrow::tools {
namespace {

constexpr const char* kFilmSize = "240x320";

// As it is given on the command line.
struct ActingOptions {
  GraphOptions graph;
  std::string script, camera, trace;
  float seconds = 0;
};

void add_movie(CLI::App* command, RenderArguments& a) {
  CLI::Option* const movie = command->add_flag(
      "--movie", a.movie,
      "a moving picture that loops: the clip, or with --time, or of what does not move, a turntable; "
      "an animated PNG (.png), or by the program ffmpeg .gif, .mp4, .webm or .webp, or, with -o FOLDER/ or "
      "-o NAME%04d.png, numbered frames; without --size one .png or .gif has 480x360");
  command->add_option("--fps", a.fps, "frames a second of a movie or a trace")
      ->type_name("N")
      ->check(CLI::Range(1, 60))
      ->capture_default_str();
  command
      ->add_option("--turn", a.turn_deg,
                   "degrees that the camera and the lights walk round the character over the movie, at most 60 a "
                   "second: a shorter clip is repeated; a turntable's default is 360")
      ->type_name("DEGREES")
      ->check(finite("degrees"))
      ->check(CLI::Range(-3600.0f, 3600.0f))
      ->needs(movie);
  command
      ->add_option("--film", a.film,
                   "so many moments in one picture, evenly over what is played; without --size each has 240x320")
      ->type_name("N")
      ->check(CLI::Range(1, 64))
      ->excludes(movie);
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

void add_acting(CLI::App* command, ActingOptions& a) {
  CLI::Option* const graph = add_graph(command, a.graph);
  command
      ->add_option("--script", a.script,
                   "what is set when: lines of TIME PARAMETER [VALUE], as in 1.5 speed 2, 3 armed true, 4 jump")
      ->type_name("FILE")
      ->check(CLI::ExistingFile)
      ->needs(graph);
  command->add_option("--seconds", a.seconds, "how long it plays; without it until 2 s after the script's last line")
      ->type_name("S")
      ->check(CLI::Range(0.0f, 3600.0f))
      ->needs(graph);
  command
      ->add_option("--camera", a.camera,
                   "follow: goes along with the character; stand: has all of its way in the picture; without it it "
                   "follows who goes farther than twice their size")
      ->type_name("WORD")
      ->check(CLI::IsMember({"follow", "stand"}))
      ->needs(graph);
  command
      ->add_option("--trace", a.trace,
                   "also write what happens in each frame: parameters, states, weights, events, the root's place; "
                   "without -o alone")
      ->type_name("T.json")
      ->needs(graph);
}

// What is meant by options of graphs, and what they do not go with.
void take_graph(const CLI::App& command, const ActingOptions& given, RenderArguments& a) {
  const auto behaviour = graph_of(command, given.graph, {"--clip", "--ik", "--between"}, a.choice);
  if (!behaviour) return;
  if (a.path == SkinPath::crowd)
    throw Failure(Exit::usage, "--path crowd", "", "crowds are baked from clips", "use another --path");
  a.acting = ActingArguments{*behaviour, given.script, std::nullopt};
  if (command.count("--seconds") > 0) a.acting->seconds = given.seconds;
  if (!a.acting->seconds && a.held) a.acting->seconds = std::max(a.choice.time_s, 0.0f);
  if (!given.camera.empty()) a.camera_follows = given.camera == "follow";
  a.trace = given.trace;
}

}  // namespace

void add_render(CLI::App& app, int&) {
  static RenderArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("render", "Draw a character at a moment of a clip or a graph, or a movie");
  add_look(command, a, kSkinPaths);
  add_outfits(command, a.outfits);
  add_reach(command, a.reach);
  add_between(command, a.between);
  add_viewpoint(command, a.viewpoint);
  command->add_flag("--springs", a.springs, "the file's springs swing as the clip moves them, from its beginning on");
  add_movie(command, a);
  static ActingOptions graph;
  add_acting(command, graph);
  command->add_option("-o,--output", a.output, "the picture, PNG, or the movie")->type_name("P.png");
  command->callback([command] {
    a.held = command->count("--time") > 0;
    take_graph(*command, graph, a);
    if (a.output.empty() && a.trace.empty()) throw CLI::RequiredError("--output");
    if (command->count("--fps") > 0 && !a.movie && a.trace.empty()) throw CLI::RequiresError("--fps", "--movie");
    if (command->count("--size") == 0 && a.movie) a.size = default_movie_size(a.output);
    if (command->count("--size") == 0 && a.film) a.size = kFilmSize;
    run_render(a);
  });
}

}  // namespace marrow::tools
