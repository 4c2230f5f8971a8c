#include "compare/compare.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "common/formats.h"
#include "compare/measure.h"
#include "compare/motion_study.h"
#include "compare/page.h"
#include "compare/thesis/thesis.h"
#include "compare/verdict.h"
#include "cook/learn/truths.h"
#include "disk/cook_on_disk.h"
#include "disk/files.h"
#include "terminal/progress.h"
#include "terminal/warnings.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json place(const Study& study, std::size_t number) {
  if (number == MotionRow::kNowhere) return {};
  const deform::MotionPose& pose = study.motion.poses[number];
  return {{"joint", study.joint_names[pose.joint]},
          {"kind", deform::name_of(pose.kind)},
          {"angle_deg", glm::degrees(pose.angle_rad)}};
}

ordered_json rows(const Study& study, const DeformerComparison& comparison, const std::vector<MotionRow>& of) {
  ordered_json out = ordered_json::array();
  for (std::size_t d = 0; d < of.size(); ++d) {
    const MotionRow& row = of[d];
    out.push_back({{"deformer", comparison.rows[d].deformer},
                   {"worse_poses", row.worse},
                   {"worse_folding_poses", row.worse_folding},
                   {"of_ssd", row.of_ssd},
                   {"worst_of_ssd", row.worst_of_ssd},
                   {"worst_pose", place(study, row.worst_pose)},
                   {"ring_over_bind", or_null(row.ring_over_bind)},
                   {"ring_over_truth", or_null(row.ring_over_truth)},
                   {"narrowest_pose", place(study, row.narrowest_pose)},
                   {"volume_over_truth", or_null(row.volume_over_truth)},
                   {"flipped_triangles", row.flipped}});
  }
  return out;
}

// docs/deformers.md has the fields.
ordered_json motion_report(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion) {
  ordered_json joints = ordered_json::array(), folding = ordered_json::array();
  for (const MotionJoint& j : motion.joints)
    joints.push_back({{"joint", study.joint_names[j.joint]},
                      {"poses", j.poses},
                      {"folding_poses", j.folding},
                      {"deformers", rows(study, comparison, j.of)}});
  for (const std::size_t i : motion.folding) {
    ordered_json pose = place(study, i);
    pose["flipped_triangles"] = motion.errors[i].truth_flipped;
    folding.push_back(std::move(pose));
  }
  return {{"poses", motion.poses},
          {"folding_poses", folding},
          {"deformers", rows(study, comparison, motion.of)},
          {"joints", joints},
          {"left_out", study.left_out_of_motion}};
}

// A table of deformers, each with the joint where it is worst.
void print_motion(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion) {
  if (motion.joints.empty()) {
    fmt::print("\nNo range of motion: no joint deforms anything alone, or the truth is known in no such pose.\n");
  } else {
    fmt::print(
        "\n{}\nEach joint alone, twisted and bent: {} joints, {} poses, and {} in which the truth itself folds\n",
        summary(comparison, motion), motion.joints.size(), motion.poses, motion.folding.size());
    fmt::print("{:<14}{:>7}{:>9}{:>10}{:>8}{:>7}{:>9}{:>8}{:>9}  {}\n", "deformer", "worse", "folding", "of ssd's",
               "worst", "ring", "truth's", "volume", "flipped", "narrowest ring beside the truth's");
  }
  const auto or_none = [](const std::optional<double>& x) { return x ? fmt::format("{:.2f}", *x) : std::string("-"); };
  for (std::size_t d = 0; d < motion.of.size(); ++d) {
    const MotionRow& r = motion.of[d];
    fmt::print("{:<14}{:>7}{:>9}{:>10.3f}{:>8.2f}{:>7}{:>9}{:>8}{:>9}  {}\n", comparison.rows[d].deformer, r.worse,
               r.worse_folding, r.of_ssd, r.worst_of_ssd, or_none(r.ring_over_bind), or_none(r.ring_over_truth),
               or_none(r.volume_over_truth), r.flipped,
               r.narrowest_pose == MotionRow::kNowhere ? "-" : title_of(study, study.motion.poses[r.narrowest_pose]));
  }
  for (const std::string& line : study.left_out_of_motion) fmt::print("left out of the range of motion: {}\n", line);
}

std::string truth_of(const CompareArguments& a) {
  const auto given = a.given.find("truth");
  return given == a.given.end() ? "cor" : given->second.back().text;
}

ordered_json look_report(const SurfaceLook& look) {
  return {{"flipped_triangles", look.flipped},
          {"bend_deg", look.bend_deg},
          {"creased_share", look.creased},
          {"jump_of_ssd", look.jump_of_ssd ? ordered_json(*look.jump_of_ssd) : ordered_json()}};
}

ordered_json report(const CompareArguments& a, const Study& study, const DeformerComparison& c,
                    const MotionStudy& motion, const Verdict& recommended, const std::vector<FramesRow>& between) {
  ordered_json rows = ordered_json::array(), frames = ordered_json::array(), folds = ordered_json::array();
  for (const TruthFold& f : c.truth_folds)
    folds.push_back({{"clip", f.clip},
                     {"time_s", f.time_s},
                     {"joint", study.joint_names[f.joint]},
                     {"flipped_triangles", f.flipped},
                     {"ssd_flipped_triangles", f.plain_flipped}});
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
                    {"look", look_report(r.look)},
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
  return {{"recommended", recommended.deformer},
          {"why", recommended.why},
          {"truth", truth_of(a)},
          {"holdout", name_of(kHoldouts, a.holdout)},
          {"trained_poses", c.trained},
          {"held_poses", c.held},
          {"diagonal", c.diagonal_m},
          {"rows", rows},
          {"truth_look", look_report(c.truth)},
          {"truth_folds", {{"poses", c.folding}, {"worst", folds}}},
          {"range_of_motion", motion_report(study, c, motion)},
          {"between_frames", frames}};
}

#ifdef MARROW_HAS_GLES
// SSD first. What is recommended is shown last, unless the user says what is to be shown.
std::vector<std::size_t> shown(const CompareArguments& a, const DeformerComparison& c, const std::string& recommended) {
  const auto row = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(c.rows, name, &DeformerRow::deformer) - c.rows.begin());
  };
  std::vector<std::size_t> out = {row("ssd")};
  std::vector<std::string> names = a.shown;
  if (names == CompareArguments().shown && recommended != "ssd" && recommended != names.back())
    names = {names.back(), recommended};
  for (const std::string& name : names) out.push_back(row(name));
  return out;
}
#endif

void print_columns(const std::vector<TableColumn>& of, const std::vector<TableLine>& lines) {
  const std::vector<TableColumn> columns = known(of, lines);
  fmt::print("{:<16}", "deformer");
  for (const TableColumn& column : columns) fmt::print("{:>{}}", column.brief, column.width);
  fmt::print("\n");
  for (const TableLine& line : lines) {
    std::string cells;
    bool says_something = false;
    for (const TableColumn& column : columns) {
      const std::optional<double> value = column.value(line, plain_of(lines));
      says_something = says_something || value;
      cells += fmt::format("{:>{}}", value ? fmt::format("{:.{}f}", *value, column.decimals) : "-", column.width);
    }
    if (says_something) fmt::print("{:<16}{}\n", line.name, cells);
  }
}

void print_table(const Study& study, const CompareArguments& a, const DeformerComparison& c, const MotionStudy& motion,
                 const Verdict& verdict) {
  fmt::print("{}\n", verdict.use);
  for (const std::string& line : verdict.why) fmt::print("{}\n", line);
  fmt::print("\n{}: truth {}, {} poses learnt from, {} held out; lengths in mm\n", study.name, truth_of(a), c.trained,
             c.held);
  const std::vector<TableLine> lines = table_lines(c, motion);
  print_columns(kLookColumns, lines);
  fmt::print("\n");
  print_columns(kCostColumns, lines);
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
        write_file_atomically((std::filesystem::path(folder) / name).string(), picture.png());
      }
  }
}

// And writes them alone, if that is asked for.
void add_pictures(const CompareArguments& a, [[maybe_unused]] const deform::Deformer& truth, PageContent& to) {
#ifdef MARROW_HAS_GLES
  const std::vector<std::size_t> rows = shown(a, to.comparison, to.verdict.deformer);
  to.worst_poses = draw_worst_poses(to.study, to.comparison, truth, rows, 3);
  to.worst_joints = draw_worst_joints(to.study, to.comparison, to.motion, truth, rows);
#endif
  if (a.pictures.empty()) return;
  write_pictures(a.pictures, "", to.worst_poses);
  write_pictures(a.pictures, "joint-", to.worst_joints);
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
  cook::Options given = a.given;
  given["as"] = {{"fit", {"--as", ""}}};
  cook::LearnOptions options = cook::with_named_files(cook::to_options(given)).learn;
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
  const Verdict recommended = verdict(study, truth_of(a), comparison, motion);
  const std::vector<FramesRow> between = study_frames(study, a.frames_hz);
  if (a.json) {
    fmt::print("{}\n", report(a, study, comparison, motion, recommended, between).dump(2));
  } else {
    print_table(study, a, comparison, motion, recommended);
    print_motion(study, comparison, motion);
    if (!a.frames_hz.empty()) print_frames(between);
  }
  if (a.out.empty() && a.pictures.empty()) return;
  PageContent content{a.in.empty() ? study.name : std::filesystem::path(a.in).filename().string(),
                      truth_of(a),
                      study,
                      comparison,
                      motion,
                      recommended,
                      {},
                      {}};
  add_pictures(a, truth, content);
  if (a.out.empty()) return;
  const std::string page = comparison_page(content);
  write_file_atomically(a.out, std::as_bytes(std::span(page.data(), page.size())));
}

}  // namespace marrow::tools
