// `marrow demo`: from artists' files to cooked ones, a contact sheet each and a table.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands/command.h"
#include "commands/demo/sheet.h"
#include "commands/demo/story_movie.h"
#include "common/failure.h"
#include "common/load_mrw.h"
#include "disk/cook_on_disk.h"
#include "disk/disk_files.h"
#include "disk/files.h"
#include "disk/thread_pool.h"
#include "pose/choose.h"
#include "render/disk/images.h"
#include "sample/embedded.h"
#include "terminal/progress.h"
#include "text/printable.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

struct DemoArguments {
  std::vector<std::string> inputs;
  std::string clip, directory;
};

// The embedded sample's name, when no input is given.
constexpr const char* kSampleName = "newt.glb";

using Row = std::vector<std::string>;

const Row kHeading = {"file",      "source B", "cooked B",  "joints", "vertices",    "clip",         "at s",
                      "sample us", "plain us", "Marrow us", "apart",  "worst joint", "contact sheet"};
constexpr std::size_t kFirstColumns[] = {0, 5, 11, 12};  // text; the others are numbers, set to the right

void print_table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(kHeading.size(), 0);
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool text = std::find(std::begin(kFirstColumns), std::end(kFirstColumns), c) != std::end(kFirstColumns);
      line += fmt::format(fmt::runtime(text ? "{:<{}}  " : "{:>{}}  "), row[c], widths[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%s\n", line.c_str());
  }
}

std::uint64_t source_bytes(const nlohmann::ordered_json& report) {
  return report.at("source").at("bytes").get<std::uint64_t>();
}

// One input: cooks it, draws its sheet, measures it. `stem` names the outputs.
Row show(const Gl& gl, const DemoArguments& arguments, const std::string& input, const std::string& stem) {
  Progress progress;
  cook::CookOptions options;
  options.learn.animation_space = cook::AnimationSpace::fit;
  options.learn.truth = cook::Truth::elastic;
  options.learn.helpers = cook::kAutoHelpers;
  progress.show(0, 0, stem);
  DiskFiles files;
  const auto tell = [&](cook::Stage stage, std::size_t done, std::size_t count) {
    if (count > 0) progress.show(done, count, stage == cook::Stage::learn ? "fitting" : "clips");
  };
  const cook::Result cooked = cook::cook_source(input, options, {files, &all_cores(), tell, nullptr});
  const std::string mrw = (std::filesystem::path(arguments.directory) / (stem + ".mrw")).string();
  write_file_atomically(mrw, cooked.file);
  // Read back, so that what is shown is what the file holds.
  const LoadedFile loaded = load_mrw(mrw);
  const File& file = loaded.file;
  std::vector<std::uint32_t> clips;
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) clips.push_back(i);
  if (!arguments.clip.empty()) clips = {find_clip(mrw, file, arguments.clip).clip};
  progress.show(0, 0, "looking");
  PlainSkin plain(input, file);
  Character character(file);
  const WorstPlace worst = find_worst(file, character, plain, clips);
  progress.show(0, 0, "measuring");
  const Timings timings = measure(file, worst.clip, plain);
  progress.show(0, 0, "drawing");
  FoundImages images(input, file, places_beside(input));
  const Textures textures(gl, file, images);
  const Sheet sheet = make_sheet(gl, {file, plain, textures, stem, timings}, worst);
  const std::string png = (std::filesystem::path(arguments.directory) / (stem + ".png")).string();
  write_png(png, sheet.image);
  std::uint64_t joints = 0, vertices = 0;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) joints += file.skeleton(i).joint_count;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) vertices += file.mesh(i).geometry.vertex_count;
  return {std::filesystem::path(input).filename().string(),
          std::to_string(source_bytes(cooked.report)),
          std::to_string(cooked.file.size()),
          std::to_string(joints),
          std::to_string(vertices),
          worst.clip ? name_of_clip(file, *worst.clip) : "(rest pose)",
          worst.joint.empty() ? "-" : fmt::format("{:.2f}", static_cast<double>(worst.time_s)),
          worst.clip ? fmt::format("{:.1f}", timings.sample_us) : "-",
          fmt::format("{:.1f}", timings.plain_us),
          fmt::format("{:.1f}", timings.as_us),
          length_text(static_cast<double>(sheet.largest_m)),
          worst.joint.empty() ? "-" : printable(worst.joint),
          png};
}

// Two inputs of the same name must not overwrite each other's pictures.
std::string unique_stem(std::vector<std::string>& taken, const std::string& input) {
  const std::string stem = std::filesystem::path(input).stem().string();
  std::string name = stem;
  for (int number = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++number) {
    name = fmt::format("{}_{}", stem, number);
  }
  taken.push_back(name);
  return name;
}

// What the sample does beyond its clips.
void show_moves(const Gl& gl, const std::string& directory) {
  const LoadedFile loaded = load_mrw((std::filesystem::path(directory) / "newt.mrw").string());
  const std::string png = (std::filesystem::path(directory) / "newt-ik.png").string();
  write_png(png, make_moves_sheet(gl, loaded.file));
  std::fprintf(stderr, "%s: feet on a slope, a hand and the eyes on a point\n", png.c_str());
  const StoryMovie movie = shoot_story(gl, (std::filesystem::path(directory) / "newt.mrw").string());
  std::fprintf(stderr, "%s: it goes by its graph, %zu frames, %.1f s\n", movie.path.c_str(), movie.frames,
               movie.duration_s);
}

// Throws Failure.
void run_demo(const DemoArguments& arguments) {
  create_folders(arguments.directory);
  std::vector<std::string> inputs = arguments.inputs;
  if (inputs.empty()) {
    inputs.push_back((std::filesystem::path(arguments.directory) / kSampleName).string());
    write_file_atomically(inputs.back(), sample_glb());
  }
  const Gl gl;
  std::vector<Row> rows = {kHeading};
  std::vector<std::string> taken;
  for (const std::string& input : inputs) {
    std::fprintf(stderr, "%s: cooking and drawing\n", input.c_str());
    rows.push_back(show(gl, arguments, input, unique_stem(taken, input)));
  }
  if (arguments.inputs.empty()) show_moves(gl, arguments.directory);
  print_table(rows);
  std::printf(
      "times: CPU, medians, one thread; every vertex with its normal by plain skinning, and by Marrow's animation "
      "space\nGL driver: %s\n",
      gl.driver().c_str());
}

}  // namespace

void add_demo(CLI::App& app, int&) {
  static DemoArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("demo", "Cook models, draw a contact sheet of each, print a table");
  command->add_option("inputs", a.inputs, "glTF files; without one, the embedded sample")->type_name("IN.glb");
  command->add_option("--clip", a.clip, "clip by name or index; without it the one where plain skinning is worst")
      ->type_name("C");
  command->add_option("-o,--output", a.directory, "folder for NAME.mrw and NAME.png")->required()->type_name("DIR");
  command->callback([] { run_demo(a); });
}

}  // namespace marrow::tools
