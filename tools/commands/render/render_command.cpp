// `marrow render`: a character at a moment of a clip or of a graph → a picture, or over it → a moving one.
#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/look_arguments.h"
#include "commands/render/acting.h"
#include "commands/render/movie.h"
#include "commands/render/sitting.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "image/caption.h"
#include "open/open_model.h"

namespace marrow::tools {
namespace {

constexpr int kFilmColumns = 8, kFilmGap = 2;
constexpr int kMostFilmPixels = 16384;

void expect_output(const RenderArguments& arguments) {
  if (!arguments.trace.empty()) {
    expect_extension(arguments.trace, {".json"});
    expect_writable(arguments.trace);
  }
  if (arguments.output.empty()) return;
  if (arguments.movie) return expect_movie_output(arguments.output);
  expect_extension(arguments.output, {".png"});
  expect_writable(arguments.output);
}

// Moments of what is played, from its first to its last; of what goes round the last is the first.
std::vector<Instant> moments_of(const Sitting& sitting, int count) {
  std::vector<Instant> out;
  const float steps = static_cast<float>(sitting.is_acting() ? std::max(count - 1, 1) : count);
  for (int i = 0; i < count; ++i) out.push_back({sitting.duration_s() * static_cast<float>(i) / steps, std::nullopt});
  return out;
}

// Moments beside each other, and in rows where there are many.
Image film_strip(Sitting& sitting, int count) {
  const std::vector<Instant> moments = moments_of(sitting, count);
  sitting.agree_on_heat(moments);
  const int rows = (count + kFilmColumns - 1) / kFilmColumns, columns = (count + rows - 1) / rows;
  const int width = columns * (sitting.width() + kFilmGap) - kFilmGap,
            height = rows * (sitting.height() + kFilmGap) - kFilmGap;
  if (width > kMostFilmPixels || height > kMostFilmPixels)
    throw Failure(Exit::usage, "--film", "", fmt::format("{}x{} pixels in all are too many", width, height),
                  fmt::format("at most {} each way: lower --size or the number of moments", kMostFilmPixels));
  Image out(width, height, {16, 18, 20});
  for (int i = 0; i < count; ++i) {
    const Instant& moment = moments[static_cast<std::size_t>(i)];
    Image image = sitting.shoot(moment);
    const float letters = std::max(7.0f, static_cast<float>(image.height) / 36);
    draw_text(image, letters, static_cast<float>(image.height) - letters, letters, {40, 44, 48},
              fmt::format("{:.2f} s", moment.time_s));
    paste(out, image, i % columns * (sitting.width() + kFilmGap), i / columns * (sitting.height() + kFilmGap));
  }
  return out;
}

// What it does is no picture: it needs no driver.
void trace(const RenderArguments& arguments, const File& file) {
  Acting acting(arguments.file, file, arguments.behaviour, arguments.acting);
  const double end_s =
      arguments.held ? static_cast<double>(arguments.choice.time_s) : static_cast<double>(acting.duration_s());
  write_file_atomically(arguments.trace, trace_text(arguments.file, acting, end_s, arguments.fps));
}

// Throws Failure.
void run_render(const RenderArguments& given) {
  expect_output(given);
  if (given.output.empty()) return trace(given, open_model(given.file, Opens::models_by_graph).file());
  RenderArguments arguments = given;
  if (arguments.movie) arguments.size = movie_size(arguments.output, arguments.size);
  Sitting sitting(arguments);
  if (!arguments.trace.empty()) trace(arguments, sitting.file());
  if (arguments.movie) return shoot_movie(arguments, sitting);
  Image image;
  if (arguments.film) {
    image = film_strip(sitting, *arguments.film);
  } else {
    const Instant instant{arguments.choice.time_s, std::nullopt};
    sitting.agree_on_heat({&instant, 1});
    image = sitting.shoot(instant);
  }
  write_png(arguments.output, image);
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.output.c_str(), image.width, image.height,
               sitting.gl().driver().c_str());
  sitting.warn_of_misses();
}

constexpr const char* kFilmSize = "240x320";

// As it is given on the command line.
struct ActingOptions {
  std::string camera;
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

void add_acting(CLI::App* command, ActingOptions& given, RenderArguments& a) {
  CLI::Option* const graph = add_graph(command, a);
  command
      ->add_option("--script", a.acting.script,
                   "what is set when: lines of TIME PARAMETER [VALUE], as in 1.5 speed 2, 3 armed true, 4 jump")
      ->type_name("FILE")
      ->check(CLI::ExistingFile)
      ->needs(graph);
  command
      ->add_option("--seconds", given.seconds, "how long it plays; without it until 2 s after the script's last line")
      ->type_name("S")
      ->check(CLI::Range(0.0f, 3600.0f))
      ->needs(graph);
  command
      ->add_option("--camera", given.camera,
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
void take_acting(const CLI::App& command, const ActingOptions& given, RenderArguments& a) {
  take_graph(command, {"--clip", "--ik", "--between"}, a);
  if (!a.by_graph) return;
  if (a.path == SkinPath::crowd)
    throw Failure(Exit::usage, "--path crowd", "", "crowds are baked from clips", "use another --path");
  if (command.count("--seconds") > 0) a.acting.seconds = given.seconds;
  if (!a.acting.seconds && a.held) a.acting.seconds = std::max(a.choice.time_s, 0.0f);
  if (!given.camera.empty()) a.camera_follows = given.camera == "follow";
}

}  // namespace

void add_render(CLI::App& app, int&) {
  static RenderArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("render", "Draw a character at a moment of a clip or a graph, or a movie");
  add_look(command, a, kSkinPaths);
  add_outfits(command, a);
  add_reach(command, a.reach);
  add_between(command, a.between);
  add_viewpoint(command, a.viewpoint);
  command->add_flag("--springs", a.springs, "the file's springs swing as the clip moves them, from its beginning on");
  add_movie(command, a);
  static ActingOptions acting;
  add_acting(command, acting, a);
  command->add_option("-o,--output", a.output, "the picture, PNG, or the movie")->type_name("P.png");
  command->callback([command] {
    a.held = command->count("--time") > 0;
    take_acting(*command, acting, a);
    if (a.output.empty() && a.trace.empty()) throw CLI::RequiredError("--output");
    if (command->count("--fps") > 0 && !a.movie && a.trace.empty()) throw CLI::RequiresError("--fps", "--movie");
    if (command->count("--size") == 0 && a.movie) a.size = default_movie_size(a.output);
    if (command->count("--size") == 0 && a.film) a.size = kFilmSize;
    run_render(a);
  });
}

}  // namespace marrow::tools
