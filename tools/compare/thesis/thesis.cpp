#include "compare/thesis/thesis.h"

#include <algorithm>
#include <chrono>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "cook/learn/truths.h"
#include "disk/cook_on_disk.h"
#include "disk/files.h"
#include "sample/embedded.h"
#include "terminal/progress.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

constexpr const char* kShown[] = {"rigid",     "stitched", "joint_local",    "ssd", "mwe", "psd",
                                  "eigenskin", "as_fit",   "as_helpers_fit5"};

double seconds_of(const deform::Deformer& deform, const deform::Pose& pose) {
  using Clock = std::chrono::steady_clock;
  deform::Positions positions;
  double best = 1e300;
  for (int i = 0; i < 5; ++i) {
    const auto start = Clock::now();
    deform(pose, positions);
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

void add_truths(const Study& study, const Shape& shape, cook::LearnOptions options, ThesisStudy& out) {
  for (const auto& [name, truth] : kJudgedTruths) {
    options.truth = truth;
    const deform::Deformer deform = cook::make_truth(study.source, options);
    ThesisRow row;
    row.algorithm = name;
    row.double_ns_per_vertex =
        1e9 * seconds_of(deform, study.rounds.front().held.front().pose) / static_cast<double>(out.vertices);
    row.labour = labour_of(name, study, 0);
    row.bends = smoothness(shape, study.motion, false, deform);
    row.twists = smoothness(shape, study.motion, true, deform);
    out.rows.push_back(std::move(row));
  }
}

// The rows of compare, with labour and smoothness.
ThesisStudy judge(const Study& study, const cook::LearnOptions& options, const DeformerComparison& comparison) {
  const Shape shape(study.source.mesh);
  ThesisStudy out{study.name, study.source.mesh.positions.size(), study.source.mesh.joint_count, {}, {}};
  const auto ssd = std::ranges::find(comparison.rows, "ssd", &DeformerRow::deformer);
  for (std::size_t d = 0; d < comparison.rows.size(); ++d) {
    const DeformerRow& from = comparison.rows[d];
    const deform::Deformer& deform = comparison.trained_in_first_round[d].deform;
    ThesisRow row;
    row.algorithm = from.deformer;
    row.ns_per_vertex = from.ns_per_vertex;
    row.double_ns_per_vertex =
        1e9 * seconds_of(deform, study.rounds.front().held.front().pose) / static_cast<double>(out.vertices);
    row.labour = labour_of(from.deformer, study, study.source.shown.size());
    row.learn_s = from.train_s;
    row.held_of_ssd = ssd->held_rms > 0 ? from.held_rms / ssd->held_rms : 1;
    row.bends = smoothness(shape, study.motion, false, deform);
    row.twists = smoothness(shape, study.motion, true, deform);
    out.rows.push_back(std::move(row));
  }
  if (options.truth != cook::Truth::examples) add_truths(study, shape, options, out);
#ifdef MARROW_HAS_GLES
  std::vector<std::size_t> shown;
  for (const char* const name : kShown) {
    const auto at = std::ranges::find(comparison.rows, name, &DeformerRow::deformer);
    if (at != comparison.rows.end()) shown.push_back(static_cast<std::size_t>(at - comparison.rows.begin()));
  }
  // Which pose is worst is said by the first one shown; it is SSD.
  const auto first = std::ranges::find(shown, static_cast<std::size_t>(ssd - comparison.rows.begin()));
  std::rotate(shown.begin(), first, shown.end());
  out.pictures = draw_worst_poses(study, comparison, cook::make_truth(study.source, options), shown, 2);
#endif
  return out;
}

ThesisStudy study_of(Study study, cook::LearnOptions options, const CompareArguments& a) {
  cook::Notes notes;
  options = cook::with_gentle_steps(std::move(options), study.source.mesh, "/meshes", notes);
  drop_unusable_poses(options, study, notes);
  const DeformerComparison comparison = [&] {
    Progress progress;
    return compare_deformers(study, options, a.eigen_fields, [&](std::size_t done, std::size_t count) {
      progress.show(done, count, study.name + ": learning and judging");
    });
  }();
  return judge(study, options, comparison);
}

ordered_json to_json(const Smoothness& s) {
  return {{"largest_jump_deg", s.largest_jump_deg}, {"rms_jump_deg", s.rms_jump_deg}, {"curvature", s.curvature}};
}

ordered_json to_json(const Thesis& thesis) {
  ordered_json out = {{"studies", ordered_json::array()}, {"driver", thesis.driver}, {"rates", ordered_json::array()}};
  for (const ThesisStudy& study : thesis.studies) {
    ordered_json rows = ordered_json::array();
    for (const ThesisRow& r : study.rows)
      rows.push_back({{"algorithm", r.algorithm},
                      {"ns_per_vertex", r.ns_per_vertex > 0 ? ordered_json(r.ns_per_vertex) : ordered_json()},
                      {"double_ns_per_vertex", r.double_ns_per_vertex},
                      {"numbers_per_vertex", r.labour.numbers_per_vertex},
                      {"files", r.labour.files},
                      {"poses", r.labour.poses},
                      {"learn_s", r.learn_s},
                      {"of_ssd", r.held_of_ssd > 0 ? ordered_json(r.held_of_ssd) : ordered_json()},
                      {"bends", to_json(r.bends)},
                      {"twists", to_json(r.twists)}});
    out["studies"].push_back(
        {{"name", study.name}, {"vertices", study.vertices}, {"joints", study.joints}, {"rows", std::move(rows)}});
  }
  for (const FrameRate& rate : thesis.rates)
    out["rates"].push_back({{"algorithm", rate.algorithm},
                            {"path", rate.path},
                            {"normals", rate.normals},
                            {"frames_per_s", rate.frames_per_s}});
  for (const Claim& c : claims(thesis))
    out["claims"].push_back({{"claim", c.claim}, {"holds", c.holds}, {"why", c.why}});
  return out;
}

void print(const Thesis& thesis) {
  for (const Claim& c : claims(thesis)) fmt::print("{}\n  {}\n", c.claim, c.holds);
  for (const ThesisStudy& study : thesis.studies) {
    fmt::print(
        "\n{}, {} vertices, {} joints: means over the range of motion, degrees between triangles' "
        "normals\n{:<18}{:>8}{:>8}{:>9}{:>9}{:>11}{:>11}{:>11}{:>11}\n",
        study.name, study.vertices, study.joints, "algorithm", "ns", "double", "learn s", "of ssd's", "bend jump",
        "RMS", "twist jump", "RMS");
    const auto or_none = [](double x) { return x > 0 ? fmt::format("{:.3g}", x) : std::string("-"); };
    for (const ThesisRow& r : study.rows)
      fmt::print("{:<18}{:>8}{:>8}{:>9}{:>9}{:>11.1f}{:>11.2f}{:>11.1f}{:>11.2f}\n", r.algorithm,
                 or_none(r.ns_per_vertex), or_none(r.double_ns_per_vertex), or_none(r.learn_s), or_none(r.held_of_ssd),
                 r.bends.largest_jump_deg, r.bends.rms_jump_deg, r.twists.largest_jump_deg, r.twists.rms_jump_deg);
  }
  fmt::print("\nframes a second, {}\n{:<18}{:<10}", thesis.driver.empty() ? "without OpenGL ES" : thesis.driver,
             "algorithm", "path");
  for (const ThesisSize& size : kThesisSizes) fmt::print("{:>12}", size.name);
  fmt::print("\n");
  for (const FrameRate& rate : thesis.rates) {
    fmt::print("{:<18}{:<10}", rate.algorithm, rate.path + (rate.normals ? " n" : ""));
    for (const double rate_hz : rate.frames_per_s) fmt::print("{:>11.0f}", rate_hz);
    fmt::print("\n");
  }
}

}  // namespace

void run_thesis(const CompareArguments& a, const cook::LearnOptions& options) {
  Thesis thesis;
  if (a.sample.empty()) {
    cook::RawScene scene = a.in.empty() ? cook::read_gltf("newt.glb", sample_glb()) : cook::read_gltf(a.in);
    thesis.studies.push_back(study_of(study_scene(std::move(scene), a.holdout, options), options, a));
  }
  if (options.truth != cook::Truth::examples) {
    cook::LearnOptions of_cylinder = options;
    if (!a.given.contains("delta-mush")) of_cylinder.delta_mush = kCylinderDeltaMush;
    of_cylinder.wide_poses = false;
    thesis.studies.push_back(study_of(study_cylinder(), of_cylinder, a));
  }
  thesis.rates = processor_rates(options);
#ifdef MARROW_HAS_GLES
  const std::vector<FrameRate> drawn = gpu_rates(a.full, thesis.driver);
  thesis.rates.insert(thesis.rates.end(), drawn.begin(), drawn.end());
#endif
  if (a.json)
    fmt::print("{}\n", to_json(thesis).dump(2));
  else
    print(thesis);
  if (a.out.empty()) return;
  const std::string page = thesis_page(thesis);
  write_file_atomically(a.out, std::as_bytes(std::span(page.data(), page.size())));
}

}  // namespace marrow::tools
