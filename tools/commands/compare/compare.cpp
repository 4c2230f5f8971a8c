#include "commands/compare/compare.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/compare/html.h"
#include "commands/compare/measure.h"
#ifdef MARROW_HAS_GLES
#include "commands/compare/motion/motion_pictures.h"
#endif
#include "commands/compare/motion/frames_study.h"
#include "commands/compare/motion/motion_report.h"
#include "commands/compare/pictures.h"
#include "commands/compare/thesis/thesis.h"
#include "commands/compare/verdict.h"
#include "common/failure.h"
#include "common/files.h"
#include "common/formats.h"
#include "cook/gltf/read.h"
#include "cook/learn/check_truth.h"
#include "terminal/progress.h"
#include "terminal/warnings.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

std::string truth_of(const CompareArguments& a) {
  const auto given = a.given.find("truth");
  return given == a.given.end() ? "cor" : given->second.back().text;
}

ordered_json report(const CompareArguments& a, const Study& study, const DeformerComparison& c,
                    const MotionStudy& motion, const std::vector<FramesRow>& between) {
  ordered_json rows = ordered_json::array(), frames = ordered_json::array();
  for (const FramesRow& r : between)
    frames.push_back({{"hz", r.hz},
                      {"interpolation", name_of(deform::kBetweenFrames, r.kind)},
                      {"frames", r.frames},
                      {"rms", r.rms},
                      {"max", r.most}});
  for (const DeformerRow& r : c.rows) {
    const auto or_null = [](double x) { return x > 0 ? ordered_json(x) : ordered_json(); };
    rows.push_back({{"deformer", r.deformer},
                    {"train_rms", r.train_rms},
                    {"train_max", r.train_max},
                    {"held_rms", r.held_rms},
                    {"held_max", r.held_max},
                    {"worse_share", r.worse_share},
                    {"volume", r.volume},
                    {"crease_deg", r.crease_deg},
                    {"normal_deg", r.normal_deg},
                    {"blended_normal_deg", r.blended_normal_deg},
                    {"bytes_per_vertex", or_null(r.bytes_per_vertex)},
                    {"ns_per_vertex", or_null(r.ns_per_vertex)},
                    {"instructions_per_vertex", or_null(r.instructions_per_vertex)},
                    {"displacements_per_vertex", or_null(r.displacements_per_vertex)},
                    {"influences", or_null(r.influences)},
                    {"palette_entries", or_null(r.palette_entries)},
                    {"mali_cycles", or_null(r.gpu.mali_cycles)},
                    {"adreno_instructions", or_null(r.gpu.adreno_instructions)},
                    {"videocore_instructions", or_null(r.gpu.videocore_instructions)}});
  }
  return {{"truth", truth_of(a)},
          {"holdout", name_of(kHoldouts, a.holdout)},
          {"trained_poses", c.trained},
          {"held_poses", c.held},
          {"diagonal", c.diagonal_m},
          {"rows", rows},
          {"range_of_motion", motion_report(study, c, motion)},
          {"between_frames", frames}};
}

#ifdef MARROW_HAS_GLES
// SSD first.
std::vector<std::size_t> shown(const CompareArguments& a, const DeformerComparison& c) {
  const auto row = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(c.rows, name, &DeformerRow::deformer) - c.rows.begin());
  };
  std::vector<std::size_t> out = {row("ssd")};
  for (const std::string& name : a.shown) out.push_back(row(name));
  return out;
}
#endif

void print_table(const Study& study, const CompareArguments& a, const DeformerComparison& c) {
  fmt::print("{}\n\n", verdict(c));
  fmt::print("{}: truth {}, {} poses learnt from, {} held out; lengths in mm\n", study.name, truth_of(a), c.trained,
             c.held);
  fmt::print("{:<14}{:>10}{:>10}{:>10}{:>10}{:>8}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>8}{:>7}{:>8}{:>6}\n", "deformer",
             "train rms", "held rms", "held max", "of ssd's", "worse", "volume", "crease", "normals", "blended",
             "B/vertex", "ns", "instr", "Mali", "Adreno", "V3D");
  const auto whole = [](double x) { return x > 0 ? fmt::format("{:.0f}", x) : std::string("-"); };
  const auto or_none = [](double x) { return x > 0 ? fmt::format("{:.2f}", x) : std::string("-"); };
  double ssd = 0;
  for (const DeformerRow& r : c.rows)
    if (r.deformer == "ssd") ssd = r.held_rms;
  for (const DeformerRow& r : c.rows)
    fmt::print(
        "{:<14}{:>10.4f}{:>10.4f}{:>10.3f}{:>10.3f}{:>7.1f}%{:>8.3f}{:>7.1f}°{:>8.2f}°{:>8.2f}°{:>9}{:>8}{:>8}{:>7}{:>"
        "8}{:>6}\n",
        r.deformer, 1e3 * r.train_rms, 1e3 * r.held_rms, 1e3 * r.held_max, ssd > 0 ? r.held_rms / ssd : 1.0,
        100 * r.worse_share, r.volume, r.crease_deg, r.normal_deg, r.blended_normal_deg, or_none(r.bytes_per_vertex),
        or_none(r.ns_per_vertex), or_none(r.instructions_per_vertex), whole(r.gpu.mali_cycles),
        whole(r.gpu.adreno_instructions), whole(r.gpu.videocore_instructions));
}

// Each a row, other than SSD's, and once.
void expect_shown(const CompareArguments& a, const cook::LearnOptions& options) {
  std::vector<std::string> rows;
  for (const Contestant& c : contestants(options, a.eigen_fields))
    if (c.name != "ssd") rows.push_back(c.name);
  for (std::size_t i = 0; i < a.shown.size(); ++i) {
    const std::string& name = a.shown[i];
    if (std::ranges::find(rows, name) == rows.end())
      throw Failure(Exit::usage, "--show", "", "no row beside ssd is called " + printable(name),
                    suggestion(name, rows));
    if (std::ranges::find(a.shown, name) != a.shown.begin() + static_cast<std::ptrdiff_t>(i))
      throw Failure(Exit::usage, "--show", "", name + " is given twice", "leave one out");
  }
}

void expect_sensible(const CompareArguments& a, const cook::LearnOptions& options) {
  constexpr std::size_t kMostRates = 16;
  if (a.frames_hz.size() > kMostRates)
    throw Failure(Exit::usage, "--frames", "", fmt::format("more than {} rates", kMostRates), "give fewer");
  for (const double hz : a.frames_hz)
    if (!(hz >= kLeastFrames_hz && hz <= kMostFrames_hz))
      throw Failure(Exit::usage, "--frames", "", "not a rate",
                    fmt::format("give {} to {} frames a second", kLeastFrames_hz, kMostFrames_hz));
  if (!a.sample.empty() && !a.frames_hz.empty())
    throw Failure(Exit::usage, "--frames", "", "the cylinder has no clips", "give IN.glb");
  if (!a.sample.empty() && options.wide_poses)
    throw Failure(Exit::usage, "--wide-poses", "", "the cylinder's poses are wide", "leave it out");
  if (!a.sample.empty() && options.truth == cook::Truth::examples)
    throw Failure(Exit::usage, "--truth", "", "the cylinder has no examples", "give another truth");
  expect_shown(a, options);
}

void print_frames(const std::vector<FramesRow>& between) {
  if (between.empty()) fmt::print("\nNo clip moves it, so nothing is between frames.\n");
  for (const FramesRow& r : between) {
    if (&r == between.data())
      fmt::print("\nBetween frames, from where the source has the surface, mm\n{:>8}{:>8}  {:<14}{:>10}{:>10}\n", "hz",
                 "frames", "interpolation", "rms", "max");
    fmt::print("{:>8.4g}{:>8}  {:<14}{:>10.4f}{:>10.3f}\n", r.hz, r.frames, name_of(deform::kBetweenFrames, r.kind),
               1e3 * r.rms, 1e3 * r.most);
  }
}

void print_warnings(const std::string& file, const cook::Notes& notes) {
  std::vector<Warning> warnings;
  for (const cook::RawWarning& w : notes.warnings) warnings.push_back({w.pointer, w.rule, w.text});
  for (const std::string& line : warning_lines(file, warnings)) fmt::print(stderr, "{}\n", line);
}

// POSE-PICTURE-CAPTION.png, the caption up to what is measured; `first` stands before it.
void write_pictures(const std::string& folder, const char* first, const std::vector<PictureRow>& rows) {
  create_folders(folder);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::size_t number = 0;
    for (const std::vector<Picture>* const pictures : {&rows[r].shapes, &rows[r].errors})
      for (const Picture& picture : *pictures) {
        const std::size_t colon = picture.caption.find(':');
        const std::string name =
            fmt::format("{}{}-{}-{}{}.png", first, r + 1, ++number, picture.caption.substr(0, colon),
                        colon == std::string::npos ? "" : "-error");
        write_file_atomically((std::filesystem::path(folder) / name).string(), picture.png);
      }
  }
}

}  // namespace

void run_compare(const CompareArguments& a) {
  if (!a.out.empty()) {
    expect_extension(a.out, {".html", ".htm"});
    expect_writable(a.out);
  }
  if (!a.pictures.empty()) expect_folder(a.pictures);
  if (a.full && !a.thesis) throw Failure(Exit::usage, "--full", "", "it is for --thesis", "leave it out");
  if (a.thesis ? !a.in.empty() && !a.sample.empty() : a.in.empty() == a.sample.empty())
    throw Failure(Exit::usage, "compare", "", "nothing to compare on, or two things",
                  "give IN.glb or --sample cylinder");
  cook::Given given = a.given;
  given["as"] = {{"fit", {"--as", ""}}};
  cook::LearnOptions options = cook::to_options(given).learn;
  expect_sensible(a, options);
  if (!a.given.contains("helpers")) options.helpers = cook::kAutoHelpers;
  if (a.thesis) return run_thesis(a, options);
  if (!a.sample.empty() && !a.given.contains("delta-mush")) options.delta_mush = kCylinderDeltaMush;
  Study study = a.sample.empty() ? study_scene(cook::read_gltf(a.in), a.holdout, options) : study_cylinder();
  cook::Notes notes;
  options = cook::with_gentle_steps(std::move(options), study.source.mesh, "/meshes", notes);
  drop_unusable_poses(options, study, notes);
  print_warnings(a.in, notes);
  const DeformerComparison comparison = [&] {
    Progress progress;
    progress.show(0, 0, study.name);
    return compare_deformers(study, options, a.eigen_fields, [&](std::size_t done, std::size_t count) {
      progress.show(done, count, "learning and judging");
    });
  }();
  const deform::Deformer truth = cook::make_truth(study.source, options);
  const MotionStudy motion = study_motion(study, comparison, truth);
  const std::vector<FramesRow> between = study_frames(study, a.frames_hz);
  if (a.json) {
    fmt::print("{}\n", report(a, study, comparison, motion, between).dump(2));
  } else {
    print_table(study, a, comparison);
    print_motion(study, comparison, motion);
    if (!a.frames_hz.empty()) print_frames(between);
  }
  if (a.out.empty() && a.pictures.empty()) return;
  PageContent content{a.in.empty() ? study.name : std::filesystem::path(a.in).filename().string(),
                      truth_of(a),
                      study,
                      comparison,
                      motion,
                      {},
                      {}};
#ifdef MARROW_HAS_GLES
  content.worst_poses = draw_worst_poses(study, comparison, truth, shown(a, comparison), 3);
  content.worst_joints = draw_worst_joints(study, comparison, motion, truth, shown(a, comparison));
#endif
  if (!a.pictures.empty()) {
    write_pictures(a.pictures, "", content.worst_poses);
    write_pictures(a.pictures, "joint-", content.worst_joints);
  }
  if (a.out.empty()) return;
  const std::string page = comparison_page(content);
  write_file_atomically(a.out, std::as_bytes(std::span(page.data(), page.size())));
}

}  // namespace marrow::tools
