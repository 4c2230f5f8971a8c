#include "commands/compare/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "commands/compare/hinges.h"
#include "commands/compare/instructions.h"
#include "common/parallel.h"
#include "common/unpack_mrw.h"
#include "cook/cook.h"
#include "deform/surface.h"
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
};

void measure_normals(const Shape& shape, const Trained& trained, const Pose& pose, const Positions& p,
                     PoseErrors& out) {
  const std::vector<glm::dvec3> own = deform::vertex_normals(p, shape.mesh.indices);
  const std::vector<glm::dvec3> shaded = shading_normals(trained, shape.bind_normals, pose, false),
                                blended = shading_normals(trained, shape.bind_normals, pose, true);
  const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  };
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (shape.mesh.influences[v].size() < 2 || own[v] == glm::dvec3(0)) continue;
    if (shaded[v] == glm::dvec3(0) || blended[v] == glm::dvec3(0)) continue;
    out.normal_rad += angle(shaded[v], own[v]);
    out.blended_normal_rad += angle(blended[v], own[v]);
    ++out.normals;
  }
}

PoseErrors pose_errors(const Shape& shape, const Trained& trained, const deform::Deformer& truth,
                       const deform::Deformer& ssd, const Pose& pose, bool all) {
  Positions ours, wanted, plain;
  trained.deform(pose, ours);
  truth(pose, wanted);
  ssd(pose, plain);
  PoseErrors out;
  for (std::size_t v = 0; v < ours.size(); ++v) {
    const double d = glm::length(ours[v] - wanted[v]), s = glm::length(plain[v] - wanted[v]);
    out.squares += d * d;
    out.ssd_squares += s * s;
    out.largest = std::max(out.largest, d);
  }
  if (!all) return out;
  const double whole = volume_of(wanted, shape.mesh.indices);
  if (whole != 0) out.volume = volume_of(ours, shape.mesh.indices) / whole;
  const std::vector<double> angles = shape.angles(ours);
  for (std::size_t h = 0; h < angles.size(); ++h)
    out.crease_rad = std::max(out.crease_rad, angles[h] - shape.bind_angles[h]);
  measure_normals(shape, trained, pose, ours, out);
  return out;
}

constexpr double kRounding = 1e-9;  // of squared errors, and of the diagonal

// Sums over rounds.
struct Totals {
  double train_squares = 0, held_squares = 0, normal_rad = 0, blended_normal_rad = 0, volume = 0;
  std::size_t trained = 0, held = 0, worse = 0, normals = 0;
};

void measure_round(const Shape& shape, const Trained& trained, const deform::Deformer& truth, const Round& round,
                   std::size_t rounds, Totals& totals, DeformerRow& row) {
  const deform::Deformer ssd = deform::ssd(shape.mesh);
  std::vector<const Pose*> shipped;
  for (const deform::TrainingPose& p : round.train)
    if (p.shipped) shipped.push_back(&p.pose);
  std::vector<PoseErrors> train(shipped.size()), held(round.held.size());
  for_each_in_parallel(train.size() + held.size(), [&](std::size_t i) {
    if (i < train.size()) {
      train[i] = pose_errors(shape, trained, truth, ssd, *shipped[i], false);
    } else {
      held[i - train.size()] = pose_errors(shape, trained, truth, ssd, round.held[i - train.size()].pose, true);
    }
  });
  const auto vertices = static_cast<double>(shape.mesh.positions.size());
  const double rounding = vertices * std::pow(kRounding * deform::diagonal(shape.mesh), 2);
  for (const PoseErrors& e : train) {
    totals.train_squares += e.squares;
    row.train_max = std::max(row.train_max, e.largest);
  }
  const bool first = totals.held == 0;
  for (const PoseErrors& e : held) {
    totals.held_squares += e.squares;
    totals.worse += e.squares > e.ssd_squares * (1 + kRounding) + rounding;
    totals.volume += e.volume;
    totals.normal_rad += e.normal_rad;
    totals.blended_normal_rad += e.blended_normal_rad;
    totals.normals += e.normals;
    row.held_max = std::max(row.held_max, e.largest);
    row.crease_deg += glm::degrees(e.crease_rad) / static_cast<double>(held.size() * rounds);
    if (first) row.error_of_pose.push_back(std::sqrt(e.squares / vertices));
  }
  totals.trained += train.size();
  totals.held += held.size();
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
  options.raw_clips = true;
  options.most_entries = kMaxJoints;  // a mesh a primitive
  const cook::CookResult cooked = cook::cook_scene(study.scene, options);
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

}  // namespace

DeformerComparison compare_deformers(const Study& study, const cook::LearnOptions& options, int eigen_fields,
                                     const deform::Progress& progress) {
  const Shape shape(study.source.mesh);
  const deform::Deformer truth = cook::make_truth(study.source, options);
  DeformerComparison out;
  out.diagonal_m = deform::diagonal(study.source.mesh);
  const std::vector<Contestant> all = contestants(options, eigen_fields);
  deform::Steps steps(progress, all.size() * study.rounds.size());
  for (const Contestant& contestant : all) {
    DeformerRow row;
    row.deformer = contestant.name;
    Totals totals;
    for (std::size_t r = 0; r < study.rounds.size(); ++r) {
      const auto start = std::chrono::steady_clock::now();
      Trained trained = contestant.train(study, study.rounds[r], options);
      row.train_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                     static_cast<double>(study.rounds.size());
      row.displacements_per_vertex += trained.displacements / static_cast<double>(study.rounds.size());
      measure_round(shape, trained, truth, study.rounds[r], study.rounds.size(), totals, row);
      if (r == 0) out.trained_in_first_round.push_back(std::move(trained));
      steps.one_more();
    }
    const auto vertices = static_cast<double>(shape.mesh.positions.size());
    if (totals.trained > 0)
      row.train_rms = std::sqrt(totals.train_squares / vertices / static_cast<double>(totals.trained));
    row.held_rms = std::sqrt(totals.held_squares / vertices / static_cast<double>(totals.held));
    row.worse_share = static_cast<double>(totals.worse) / static_cast<double>(totals.held);
    row.volume = totals.volume / static_cast<double>(totals.held);
    const auto normals = static_cast<double>(std::max<std::size_t>(1, totals.normals));
    row.normal_deg = glm::degrees(totals.normal_rad / normals);
    row.blended_normal_deg = glm::degrees(totals.blended_normal_rad / normals);
    measure_cost(study, contestant, row);
    out.trained = totals.trained;
    out.held = totals.held;
    out.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace marrow::tools
