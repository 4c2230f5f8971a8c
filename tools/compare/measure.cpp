#include "compare/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/parallel.h"
#include "common/unpack_mrw.h"
#include "compare/instructions.h"
#include "compare/surface_look.h"
#include "deform/look/folds.h"
#include "deform/surface.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

using deform::Pose;
using deform::Positions;

// About the middle, so that a mesh that is not closed does not depend on where it stands.
double volume_of(Positions p, const std::vector<std::uint32_t>& indices) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& v : p) middle += v / static_cast<double>(p.size());
  for (glm::dvec3& v : p) v -= middle;
  return deform::volume(p, indices);
}

struct PoseErrors {
  double squares = 0, largest = 0, ssd_squares = 0;
  double volume = 1, crease_rad = 0;
  double normal_rad = 0, blended_normal_rad = 0;  // summed
  std::size_t normals = 0;
  deform::Folds folds;
};

// What deformers are judged by.
struct Judge {
  explicit Judge(const deform::SkinnedMesh& mesh) : shape(mesh), meter(mesh), ssd(deform::ssd(mesh)) {}
  Shape shape;
  deform::FoldMeter meter;
  deform::Deformer ssd, truth;
};

// How the truth looks in a pose.
struct TruthLook {
  deform::Folds folds;
  std::size_t plain_flipped = 0;
  std::uint32_t joint = 0;  // that most of what is flipped follows
};

// A pose that all deformers are judged in.
struct JudgedPose {
  const Pose* pose;
  bool is_held;
  // By the truth and by plain skinning.
  Positions wanted, plain;
  double ssd_squares = 0, volume = 0;
  std::vector<glm::dvec3> facing;  // see deform::FoldMeter

  void place(const Judge& judge) {
    judge.truth(*pose, wanted);
    judge.ssd(*pose, plain);
    for (std::size_t v = 0; v < wanted.size(); ++v) ssd_squares += glm::dot(plain[v] - wanted[v], plain[v] - wanted[v]);
    if (!is_held) return;
    volume = volume_of(wanted, judge.shape.mesh.indices);
    facing = judge.meter.facing(*pose);
  }

  TruthLook look(const Judge& judge) const {
    const std::vector<std::size_t> flipped = judge.meter.flipped_by_joint(facing, wanted);
    const auto most = std::ranges::max_element(flipped);
    return {judge.meter.of(facing, wanted), judge.meter.of(facing, plain).flipped,
            static_cast<std::uint32_t>(most - flipped.begin())};
  }
};

void measure_normals(const Shape& shape, const Trained& trained, const Pose& pose, const Positions& p,
                     PoseErrors& out) {
  const std::vector<glm::dvec3> own = deform::vertex_normals(p, shape.mesh.indices);
  const Pose extended = trained.extend(pose);
  const bool are_one = !trained.normals && trained.tangents.empty();
  const std::vector<glm::dvec3> shaded = are_one           ? std::vector<glm::dvec3>()
                                         : trained.normals ? trained.normals(pose)
                                                           : deform::surface_normals(trained.tangents, extended);
  const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  };
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (shape.mesh.influences[v].size() < 2 || own[v] == glm::dvec3(0)) continue;
    const glm::dvec3 blended = blended_normal(trained.blend[v], extended, shape.bind_normals[v]);
    if (blended == glm::dvec3(0) || (!are_one && shaded[v] == glm::dvec3(0))) continue;
    const double off = angle(blended, own[v]);
    out.normal_rad += are_one ? off : angle(shaded[v], own[v]);
    out.blended_normal_rad += off;
    ++out.normals;
  }
}

PoseErrors pose_errors(const Judge& judge, const Trained& trained, const JudgedPose& judged) {
  const Shape& shape = judge.shape;
  Positions ours;
  trained.deform(*judged.pose, ours);
  PoseErrors out;
  out.ssd_squares = judged.ssd_squares;
  for (std::size_t v = 0; v < ours.size(); ++v) {
    const double square = glm::dot(ours[v] - judged.wanted[v], ours[v] - judged.wanted[v]);
    out.squares += square;
    out.largest = std::max(out.largest, square);
  }
  out.largest = std::sqrt(out.largest);
  if (!judged.is_held) return out;
  if (judged.volume != 0) out.volume = volume_of(ours, shape.mesh.indices) / judged.volume;
  out.crease_rad = shape.sharpest_rad(ours);
  out.folds = judge.meter.of(judged.facing, ours);
  measure_normals(shape, trained, *judged.pose, ours, out);
  return out;
}

constexpr double kRounding = 1e-9;  // of squared errors, and of the diagonal

// Sums over rounds.
struct Totals {
  double train_squares = 0, held_squares = 0, normal_rad = 0, blended_normal_rad = 0, volume = 0;
  std::size_t trained = 0, held = 0, worse = 0, normals = 0;
};

struct RoundErrors {
  std::vector<std::vector<PoseErrors>> of;  // each deformer, in each pose: those learnt from, then those held out
  std::vector<TruthLook> truth;             // in those held out
};

// A pose is the truth's and plain skinning's once, and kept no longer than it is judged.
RoundErrors errors_in_round(const Judge& judge, const std::vector<Trained>& all, const Round& round) {
  std::vector<std::pair<const Pose*, bool>> poses;  // and whether it is held out
  for (const deform::TrainingPose& p : round.train)
    if (p.shipped) poses.emplace_back(&p.pose, false);
  const std::size_t trained = poses.size();
  for (const HeldPose& p : round.held) poses.emplace_back(&p.pose, true);
  RoundErrors out;
  out.of.assign(all.size(), std::vector<PoseErrors>(poses.size()));
  out.truth.resize(round.held.size());
  for_each_in_parallel(poses.size(), [&](std::size_t i) {
    JudgedPose judged{poses[i].first, poses[i].second, {}, {}, 0, 0, {}};
    judged.place(judge);
    if (judged.is_held) out.truth[i - trained] = judged.look(judge);
    for (std::size_t d = 0; d < all.size(); ++d) out.of[d][i] = pose_errors(judge, all[d], judged);
  });
  return out;
}

// Adds one of `poses` to means.
void add_look(const deform::Folds& folds, double poses, SurfaceLook& look) {
  look.flipped += static_cast<double>(folds.flipped) / poses;
  look.bend_deg += folds.bend_rad * folds.bend_rad / poses;  // until finish()
  look.creased += folds.creased / poses;
}

void finish(SurfaceLook& look) {
  look.bend_deg = glm::degrees(std::sqrt(look.bend_deg));
}

// One triangle that faces inwards nobody sees, a thousandth of them is a patch as large as a fingertip.
constexpr double kFolds = 1e-3;
constexpr double kStill = 1e-9;  // of the diagonal: what is below is rounding of what joints carry

void add_truth(const std::vector<TruthLook>& looks, const Round& round, std::size_t triangles,
               DeformerComparison& out) {
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const TruthLook& look = looks[i];
    const HeldPose& held = round.held[i];
    if (static_cast<double>(look.folds.flipped) <= kFolds * static_cast<double>(triangles)) continue;
    ++out.folding;
    auto at = std::ranges::find(out.truth_folds, held.clip, &TruthFold::clip);
    if (at == out.truth_folds.end()) at = out.truth_folds.insert(at, {held.clip, 0, 0, 0, 0});
    if (look.folds.flipped > at->flipped)
      *at = {held.clip, held.time_s, look.joint, look.folds.flipped, look.plain_flipped};
  }
  std::ranges::stable_sort(out.truth_folds, std::greater<>(), &TruthFold::flipped);
}

// errors: of poses learnt from, then of those held out.
void add_round(const Shape& shape, const std::vector<PoseErrors>& errors, const Round& round, double held,
               Totals& totals, DeformerRow& row) {
  const auto vertices = static_cast<double>(shape.mesh.positions.size());
  const double rounding = vertices * std::pow(kRounding * deform::diagonal(shape.mesh), 2);
  const std::size_t trained = errors.size() - round.held.size();
  const bool first = totals.held == 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const PoseErrors& e = errors[i];
    if (i < trained) {
      totals.train_squares += e.squares;
      row.train_max = std::max(row.train_max, e.largest);
      continue;
    }
    totals.held_squares += e.squares;
    totals.worse += e.squares > e.ssd_squares * (1 + kRounding) + rounding;
    totals.volume += e.volume;
    totals.normal_rad += e.normal_rad;
    totals.blended_normal_rad += e.blended_normal_rad;
    totals.normals += e.normals;
    row.held_max = std::max(row.held_max, e.largest);
    row.crease_deg += glm::degrees(e.crease_rad) / held;
    add_look(e.folds, held, row.look);
    if (first) row.error_of_pose.push_back(std::sqrt(e.squares / vertices));
  }
  totals.trained += trained;
  totals.held += round.held.size();
}

static_assert(static_cast<int>(GpuDeformer::rigid) == static_cast<int>(Contestant::Kernel::rigid) &&
              static_cast<int>(GpuDeformer::ssd) == static_cast<int>(Contestant::Kernel::ssd) &&
              static_cast<int>(GpuDeformer::as) == static_cast<int>(Contestant::Kernel::as) &&
              static_cast<int>(GpuDeformer::psd) == static_cast<int>(Contestant::Kernel::psd));

// A kernel on the mesh's primitives, in the rest pose.
class KernelRun {
 public:
  KernelRun(const File& file, const Study& study, Contestant::Kernel kernel) : kernel_(kernel) {
    Character character(file);
    for (std::uint32_t i = 0; i < study.source.vertex_of.size(); ++i) {
      Part& part = parts_.emplace_back();
      part.mesh = file.mesh(i);
      const Geometry& g = part.mesh.geometry;
      const auto palette = character.palette(i);
      part.palette.assign(palette.data(), palette.data() + palette.size());
      part.coordinates.resize(as_coordinate_count(g));
      check(as_coordinates(g, part.coordinates));
      part.distances.resize(psd_distance_count(g));
      part.positions.resize(std::size_t{3} * g.slot_count);
      vertices_ += g.vertex_count;
    }
  }
  // Whether the file has what the kernel needs.
  bool is_possible() const {
    return std::ranges::all_of(parts_, [&](const Part& p) {
      return kernel_ == Contestant::Kernel::mwe   ? p.mesh.geometry.mwe_residual != nullptr
             : kernel_ == Contestant::Kernel::psd ? !p.distances.empty()
                                                  : true;
    });
  }
  double vertices() const { return vertices_; }
  std::uint32_t most_influences() const {
    std::uint32_t out = 0;
    for (const Part& p : parts_)
      for (const Run& r : p.mesh.geometry.runs) out = std::max(out, r.influences);
    return out;
  }
  std::uint32_t most_palette_entries() const {
    std::uint32_t out = 0;
    for (const Part& p : parts_) out = std::max(out, p.mesh.palette_size());
    return out;
  }
  // The mean over vertices, each drawn with normals; zeros where no path of the GPU has the kernel.
  VertexCost gpu_cost() const {
    VertexCost out;
    if (kernel_ > Contestant::Kernel::psd) return out;
    const auto deformer = static_cast<GpuDeformer>(kernel_);
    for (const Part& p : parts_) {
      const std::optional<VertexCost> cost = vertex_cost(p.mesh.geometry, deformer);
      if (!cost) return {};
      const double share = p.mesh.geometry.vertex_count / vertices_;
      out.mali_cycles += share * cost->mali_cycles;
      out.adreno_instructions += share * cost->adreno_instructions;
      out.videocore_instructions += share * cost->videocore_instructions;
      out.spills = out.spills || cost->spills;
    }
    return out;
  }
  void operator()() {
    for (Part& p : parts_) check(deform(p));
  }

 private:
  struct Part {
    Mesh mesh;
    std::vector<Affine> palette;
    std::vector<float> coordinates, distances, positions;
  };
  Status deform(Part& p) const {
    SkinOutput out;
    out.positions = p.positions;
    switch (kernel_) {
      case Contestant::Kernel::rigid:
        return skin_rigid(p.mesh, p.palette, out);
      case Contestant::Kernel::ssd:
        return skin_ssd(p.mesh, p.palette, out);
      case Contestant::Kernel::as:
        return skin_as(p.mesh, p.coordinates, p.palette, out);
      case Contestant::Kernel::mwe:
        return skin_mwe(p.mesh, p.palette, out);
      case Contestant::Kernel::psd:
        break;
    }
    check(psd_distances(p.mesh.geometry, p.palette, p.distances));
    return skin_psd(p.mesh, p.distances, p.palette, out);
  }

  Contestant::Kernel kernel_;
  std::vector<Part> parts_;
  double vertices_ = 0;
};

// Nanoseconds, the best of several runs.
double time_of(KernelRun& run) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRuns = 40;
  double best = 1e300;
  for (int i = 0; i < kRuns; ++i) {
    const auto start = Clock::now();
    run();
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return best;
}

void measure_cost(const Study& study, const Contestant& contestant, DeformerRow& row) {
  if (!contestant.can_be_cooked) return;
  cook::CookOptions options;
  options.learn = contestant.cooked;
  options.learn.known_elastic = study.source.elastic;
  options.clips.raw = true;
  options.mesh.most_entries = kMaxJoints;  // a mesh a primitive
  const cook::Result cooked = cook::cook_scene(study.scene, options);
  const AlignedBytes unpacked = tools::unpacked(cooked.file, study.scene.source);
  File file;
  check(load({unpacked.data(), unpacked.size()}, file));
  KernelRun run(file, study, contestant.kernel);
  if (!run.is_possible()) return;
  double bytes = 0;
  for (std::size_t i = 0; i < study.source.vertex_of.size(); ++i)
    bytes += cooked.report["meshes"][i]["bytes"].get<double>();
  row.bytes_per_vertex = bytes / run.vertices();
  row.ns_per_vertex = time_of(run) / run.vertices();
  row.gpu = run.gpu_cost();
  row.influences = run.most_influences();
  row.palette_entries = run.most_palette_entries();
  if (const auto count = count_instructions([&] { run(); }))
    row.instructions_per_vertex = static_cast<double>(*count) / run.vertices();
}

// Mean and root mean square over all rounds.
void finish(const Totals& totals, double vertices, DeformerRow& row) {
  if (totals.trained > 0)
    row.train_rms = std::sqrt(totals.train_squares / vertices / static_cast<double>(totals.trained));
  row.held_rms = std::sqrt(totals.held_squares / vertices / static_cast<double>(totals.held));
  row.worse_share = static_cast<double>(totals.worse) / static_cast<double>(totals.held);
  row.volume = totals.volume / static_cast<double>(totals.held);
  const auto normals = static_cast<double>(std::max<std::size_t>(1, totals.normals));
  finish(row.look);
  row.normal_deg = glm::degrees(totals.normal_rad / normals);
  row.blended_normal_deg = glm::degrees(totals.blended_normal_rad / normals);
}

void add_jumps(const Study& study, const deform::Deformer& truth, DeformerComparison& out) {
  const auto ssd = std::ranges::find(out.rows, "ssd", &DeformerRow::deformer);
  const auto jumps = largest_jumps(study, out.trained_in_first_round, truth, ssd->error_of_pose);
  const std::optional<double> plain = jumps[static_cast<std::size_t>(ssd - out.rows.begin())];
  if (!plain || !(*plain > kStill * out.diagonal_m)) return;
  for (std::size_t d = 0; d <= out.rows.size(); ++d)
    if (jumps[d]) (d < out.rows.size() ? out.rows[d].look : out.truth).jump_of_ssd = *jumps[d] / *plain;
}

}  // namespace

bool reads_more(double a, double b, int decimals) {
  const double written = std::pow(10.0, decimals);
  return std::round(written * a) > std::round(written * b);
}

DeformerComparison compare_deformers(const Study& study, const cook::LearnOptions& options, int eigen_fields,
                                     const deform::Progress& progress) {
  Judge judge(study.source.mesh);
  judge.truth = cook::make_truth(study.source, options);
  DeformerComparison out;
  out.diagonal_m = deform::diagonal(study.source.mesh);
  const std::vector<Contestant> all = contestants(options, eigen_fields);
  const auto rounds = static_cast<double>(study.rounds.size());
  double held = 0;
  for (const Round& round : study.rounds) held += static_cast<double>(round.held.size());
  deform::Steps steps(progress, (all.size() + 1) * study.rounds.size());
  out.rows.resize(all.size());
  std::vector<Totals> totals(all.size());
  for (const Round& round : study.rounds) {
    std::vector<Trained> trained;
    for (std::size_t d = 0; d < all.size(); ++d) {
      DeformerRow& row = out.rows[d];
      row.deformer = all[d].name;
      const auto start = std::chrono::steady_clock::now();
      trained.push_back(all[d].train(study, round, options));
      row.train_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / rounds;
      row.displacements_per_vertex += trained.back().displacements / rounds;
      steps.one_more();
    }
    const RoundErrors errors = errors_in_round(judge, trained, round);
    for (std::size_t d = 0; d < all.size(); ++d)
      add_round(judge.shape, errors.of[d], round, held, totals[d], out.rows[d]);
    for (const TruthLook& look : errors.truth) add_look(look.folds, held, out.truth);
    add_truth(errors.truth, round, study.source.mesh.indices.size() / 3, out);
    if (out.trained_in_first_round.empty()) out.trained_in_first_round = std::move(trained);
    steps.one_more();
  }
  out.trained = totals.front().trained;
  out.held = totals.front().held;
  finish(out.truth);
  for (std::size_t d = 0; d < all.size(); ++d) {
    finish(totals[d], static_cast<double>(judge.shape.mesh.positions.size()), out.rows[d]);
    measure_cost(study, all[d], out.rows[d]);
  }
  add_jumps(study, judge.truth, out);
  return out;
}

}  // namespace marrow::tools
