// The program `marrow`: the command line of every sub-command, and the one place where failures become exit codes. What
// a sub-command does is in the folder of its name.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <new>
#include <span>

#include <CLI/CLI.hpp>

#include "commands/bench/bench.h"
#include "commands/compare/compare.h"
#include "commands/cook/command_line.h"
#include "commands/diff/diff.h"
#include "commands/info/info.h"
#include "commands/pose/write_pose.h"
#include "common/failure.h"
#include "common/files.h"
#include "export/export.h"
#include "sample/embedded.h"
#ifdef MARROW_HAS_GLES
#include "commands/bench/gpu.h"
#include "commands/demo/demo.h"
#include "commands/render/render.h"
#include "render/paths.h"
#endif
#ifdef MARROW_HAS_VIEW
#include "commands/view/view.h"
#endif

namespace marrow::tools {
namespace {

// Arguments live as long as the process, as the options that point at them do.
template <class Arguments>
Arguments& arguments_of() {
  static Arguments arguments;
  return arguments;
}

void add_input(CLI::App* command, std::string& to) {
  command->add_option("file", to, "the cooked file")->required()->type_name("FILE");
}

CLI::Validator finite(const std::string& unit) {
  const auto check = [unit](const std::string& text) {
    float value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool good = error == std::errc() && stop == end && std::isfinite(value);
    return good ? std::string() : "not a finite number of " + unit + ": " + text;
  };
  return {check, ""};
}

void add_choice(CLI::App* command, Choice& choice) {
  command
      ->add_option("--clip", choice.clip,
                   "clip by name: all of that name, one a skeleton; or one clip by index; without it the rest pose")
      ->type_name("C");
  command->add_option("--clips", choice.clips, "take the clip from this clip pack")->type_name("PACK.mrw");
  command
      ->add_option("--time", choice.time_s, "seconds from the clip's start; outside the clip its first or last moment")
      ->type_name("S")
      ->check(finite("seconds"));
}

void add_deformer(CLI::App* command, std::string& to) {
  command->add_option("--deformer", to, "how vertices follow joints")
      ->check(CLI::IsMember({"rigid", "ssd", "as"}))
      ->capture_default_str();
}

void add_info(CLI::App& app) {
  InfoArguments& a = arguments_of<InfoArguments>();
  CLI::App* const command = app.add_subcommand("info", "Say what a cooked file holds");
  add_input(command, a.in);
  command->add_option("--source", a.source, "the glTF file it was cooked from, to show its bytes beside")
      ->type_name("IN.glb");
  command->add_flag("--json", a.json, "as JSON");
  command->callback([&a] { run_info(a); });
}

void add_diff(CLI::App& app) {
  DiffArguments& a = arguments_of<DiffArguments>();
  CLI::App* const command = app.add_subcommand("diff", "Say in what two cooked files differ");
  command->add_option("a", a.a, "a cooked file")->required()->type_name("A.mrw");
  command->add_option("b", a.b, "another")->required()->type_name("B.mrw");
  command->add_flag("--json", a.json, "as JSON: {equal, differences: [{kind, in, text, ...}]}");
  command->footer("Exit codes: 0 the same bytes, 6 they differ, others as ever.");
  command->callback([&a] { run_diff(a); });
}

void add_export(CLI::App& app) {
  ExportArguments& a = arguments_of<ExportArguments>();
  CLI::App* const command = app.add_subcommand("export", "Write a cooked file back as plain glTF 2.0");
  add_input(command, a.in);
  command->add_option("-o,--output", a.out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([&a] { run_export(a); });
}

void add_pose(CLI::App& app) {
  PoseArguments& a = arguments_of<PoseArguments>();
  CLI::App* const command = app.add_subcommand("pose", "Write a character's vertices at a moment of a clip");
  add_input(command, a.in);
  add_choice(command, a.choice);
  add_deformer(command, a.deformer);
  command
      ->add_option("-o,--output", a.out, "P.bin: little-endian float32 x y z a vertex, scene space; P.obj: Wavefront")
      ->required()
      ->type_name("P.obj|P.bin");
  command->callback([&a] { run_pose(a); });
}

void add_bench(CLI::App& app) {
  BenchArguments& a = arguments_of<BenchArguments>();
  CLI::App* const command = app.add_subcommand("bench", "Measure every stage, a joint or a vertex");
  command->add_option("--only", a.only, "rows by name; * and ? stand for any characters, slashes too")
      ->type_name("GLOB")
      ->capture_default_str();
  command
      ->add_option("--iterations", a.iterations, "run each row exactly so often; without it, as often as steadies it")
      ->type_name("N")
      ->check(CLI::Range(1u, 1000000000u));
  command->add_flag("--json", a.json,
                    "as JSON: [{name, items, ns_per_item, hash}]; with --gpu {driver, rows: [{name, frames_per_s, "
                    "ns_per_vertex, gpu_ns_per_vertex}]}");
#ifdef MARROW_HAS_GLES
  GpuBenchArguments& on_gpu = arguments_of<GpuBenchArguments>();
  CLI::Option* const gpu =
      command->add_flag("--gpu", on_gpu.wanted, "frames drawn by OpenGL ES, by every skinning path");
  command->add_option("-o,--output", on_gpu.chart, "with --gpu also a chart")->type_name("OUT.svg")->needs(gpu);
  gpu->excludes(command->get_option("--iterations"));
#endif
  command->footer([] {
    std::string names = bench_row_names();
#ifdef MARROW_HAS_GLES
    names += "with --gpu\n" + gpu_row_names();
#endif
    return "Models are looked for in the folder that the environment variable MARROW_ASSETS names. Rows:\n" + names;
  });
  command->callback([&a] {
#ifdef MARROW_HAS_GLES
    GpuBenchArguments& with_gpu = arguments_of<GpuBenchArguments>();
    with_gpu.only = a.only;
    with_gpu.json = a.json;
    if (with_gpu.wanted) return run_gpu_bench(with_gpu);
#endif
    run_bench(a);
  });
}

void add_compare(CLI::App& app) {
  CompareArguments& a = arguments_of<CompareArguments>();
  CLI::App* const command = app.add_subcommand("compare", "Say which deformer a character should use");
  command->add_option("file", a.in, "a glTF file with a skin and clips")->type_name("IN.glb");
  command->add_option("--sample", a.sample, "instead of a file, a mesh that deformers are commonly shown on")
      ->check(CLI::IsMember({"cylinder"}));
  add_cook_options(command, {"truth", "examples", "delta-mush", "influences", "keep-bind-pose"}, a.given);
  command
      ->add_option("--holdout", a.holdout,
                   "what is not learnt from but judged by: alternate frames of every clip, or whole clips in turn")
      ->check(CLI::IsMember({"frames", "clips"}))
      ->capture_default_str();
  command->add_flag(
      "--json", a.json,
      "as JSON: {truth, holdout, trained_poses, held_poses, diagonal, rows: [{deformer, train_rms, train_max, "
      "held_rms, held_max, worse_share, volume, crease_deg, normal_deg, blended_normal_deg, bytes_per_vertex, "
      "ns_per_vertex, instructions_per_vertex}]}, "
      "lengths in metres");
  command->add_option("-o,--output", a.out, "also a page with pictures and charts, in one file")->type_name("OUT.html");
#ifdef MARROW_HAS_GLES
  command->add_option("--pictures", a.pictures, "also the page's pictures, each a PNG in this folder")
      ->type_name("FOLDER");
#endif
  command->callback([&a] { run_compare(a); });
}

void add_sample(CLI::App& app) {
  std::string& out = arguments_of<std::string>();
  CLI::App* const command = app.add_subcommand("sample", "Write the embedded sample character as a .glb file");
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([&out] { write_file_atomically(out, sample_glb()); });
}

#ifdef MARROW_HAS_GLES
void add_skin_path(CLI::App* command, std::string& to, std::span<const NamedSkinPath> paths) {
  std::vector<std::string> names;
  std::string about;
  for (const NamedSkinPath& path : paths) {
    names.emplace_back(path.name);
    about.append(about.empty() ? "" : "; ").append(path.name).append(": ").append(path.about);
  }
  command->add_option("--path", to, about)->check(CLI::IsMember(names))->capture_default_str();
}

void add_movie(CLI::App* command, RenderArguments& a) {
  CLI::Option* const movie =
      command->add_flag("--movie", a.movie,
                        "a moving picture that loops: the clip, or with --time, or of what does not move, a turntable; "
                        "an animated PNG, or, with -o FOLDER/ or -o NAME%04d.png, numbered frames");
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

void add_look(CLI::App* command, LookArguments& a, std::span<const NamedSkinPath> paths) {
  add_input(command, a.file);
  add_choice(command, a.choice);
  add_deformer(command, a.deformer);
  add_skin_path(command, a.path, paths);
  command
      ->add_option(
          "--normals", a.normals,
          "in animation space: of the deformed surface, through its tangents, or, cheaper, through the blended "
          "matrix, as meshes with morph targets and, by the vertex shader, with more than four influences")
      ->check(CLI::IsMember({"tangents", "blended"}))
      ->capture_default_str();
  command->add_option("--size", a.size, "pixels")->type_name("WxH")->capture_default_str();
  command->add_option("--lod", a.lod, "level of detail; 0: in full")->type_name("N")->capture_default_str();
  command->add_option("--heatmap", a.heatmap, "colour the distance between two deformers, as in ssd:as")
      ->type_name("A:B");
  command
      ->add_option("--images-from", a.images_from,
                   "where images by reference are looked for, here and below; without it, the cooked file's folder")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
}

void add_reach(CLI::App* command, ReachArguments& a) {
  CLI::Option* const goal =
      command->add_option("--ik", a.goals, "bring a joint to a point of the scene, metres; may be given several times")
          ->type_name("JOINT=X,Y,Z")
          ->expected(1)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      ->add_option("--ik-solver", a.solver,
                   "two_bone: the two joints above, in closed form; others: by iteration, within the limits that the "
                   "file has")
      ->check(CLI::IsMember(ik_solver_names()))
      ->capture_default_str()
      ->needs(goal);
  command
      ->add_option("--ik-joints", a.joints,
                   "how many joints above turn, not counting those called twist or roll; two_bone: two")
      ->type_name("N")
      ->check(CLI::Range(1, 32767))
      ->capture_default_str()
      ->needs(goal);
}

void add_render(CLI::App& app) {
  RenderArguments& a = arguments_of<RenderArguments>();
  CLI::App* const command = app.add_subcommand("render", "Draw a character at a moment of a clip, or a movie");
  add_look(command, a, kSkinPaths);
  add_reach(command, a.reach);
  add_movie(command, a);
  command->add_option("-o,--output", a.output, "the picture, PNG")->required()->type_name("P.png");
  command->callback([&a, command] {
    a.held = command->count("--time") > 0;
    run_render(a);
  });
}

void add_demo(CLI::App& app) {
  DemoArguments& a = arguments_of<DemoArguments>();
  CLI::App* const command = app.add_subcommand("demo", "Cook models, draw a contact sheet of each, print a table");
  command->add_option("inputs", a.inputs, "glTF files; without one, the embedded sample")->type_name("IN.glb");
  command->add_option("--clip", a.clip, "clip by name or index; without it the one that bends joints most")
      ->type_name("C");
  command->add_option("-o,--output", a.directory, "folder for NAME.mrw and NAME.png")->required()->type_name("DIR");
  command->callback([&a] { run_demo(a); });
}
#endif

#ifdef MARROW_HAS_VIEW
void add_view(CLI::App& app) {
  ViewArguments& a = arguments_of<ViewArguments>();
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
  command->callback([&a, command] {
    a.held = command->count("--time") > 0;
    run_view(a);
  });
}
#endif

int run(int argc, char** argv) {
  CLI::App app{"Marrow: skeletal animation, from glTF to pixels.", "marrow"};
  app.require_subcommand(1);
  app.set_version_flag("--version", MARROW_VERSION);
  app.footer(
      "Results go to stdout, everything else to stderr.\n"
      "Exit codes: 0 done, 1 usage, 2 input/output, 3 invalid input, 4 unsupported, 5 internal, "
      "6 files differ (diff).");
  int exit_code = 0;
  add_cook(app, exit_code);
  add_info(app);
  add_diff(app);
  add_export(app);
  add_pose(app);
  add_bench(app);
  add_compare(app);
  add_sample(app);
#ifdef MARROW_HAS_GLES
  add_render(app);
  add_demo(app);
#endif
#ifdef MARROW_HAS_VIEW
  add_view(app);
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    std::fprintf(stderr, "marrow: %s (see --help)\n", e.what());
    return static_cast<int>(Exit::usage);
  }
  return arguments_of<DiffArguments>().differs ? kFilesDiffer : exit_code;
}

}  // namespace
}  // namespace marrow::tools

int main(int argc, char** argv) {
  using marrow::tools::Exit;
  try {
    return marrow::tools::run(argc, argv);
  } catch (const marrow::tools::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(failure.code());
  } catch (const std::bad_alloc&) {
    std::fputs("marrow: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "marrow: internal error: %s\n", e.what());
  }
  return static_cast<int>(Exit::internal);
}
