#include "cook/learn/learn.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/learn/check_truth.h"
#include "marrow/file.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kCandidates = 8;  // of smoothed weights

// With half-joints one more, as they come beside joints.
std::size_t most_joints(const LearnOptions& options) {
  return static_cast<std::size_t>(options.influences > 0 ? options.influences : options.half_joints > 0 ? 5 : 4);
}

// What a vertex may follow, and the best guess without examples: to delta mush the joints that smoothing reaches, of
// which much is known in closed form; else its own.
deform::Coordinates make_candidates(const deform::SkinnedMesh& mesh, const LearnOptions& options) {
  if (options.truth != Truth::delta_mush) return deform::lift(mesh);
  const deform::DeltaMushOptions& mush = options.delta_mush;
  deform::Coordinates out =
      deform::smoothed_ssd(mesh, deform::Surface(mesh, mush.weights), mush.iterations, mush.step, kCandidates);
  for (std::size_t v = 0; v < out.size(); ++v) {
    for (const deform::Influence& i : mesh.influences[v])
      if (std::ranges::find(out[v], i.joint, &deform::Coordinate::joint) == out[v].end())
        out[v].push_back({i.joint, glm::dvec4(0)});
    std::ranges::sort(out[v], {}, &deform::Coordinate::joint);
  }
  return out;
}

// SSD smoothed, or SSD where its joints and those leave no room for each other.
deform::Coordinates smoothed(const deform::SkinnedMesh& mesh, const LearnOptions& options) {
  const deform::DeltaMushOptions& mush = options.delta_mush;
  deform::Coordinates out =
      deform::smoothed_ssd(mesh, deform::Surface(mesh, mush.weights), mush.iterations, mush.step, most_joints(options));
  const deform::Coordinates lifted = deform::lift(mesh);
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    std::set<std::uint32_t> joints;
    for (const deform::Coordinate& c : lifted[v]) joints.insert(c.joint);
    for (const deform::Coordinate& c : out[v]) joints.insert(c.joint);
    if (joints.size() > kMaxInfluences) out[v] = lifted[v];
  }
  return out;
}

Learnt as_it_is(const deform::SkinnedMesh& mesh) {
  return {deform::lift(mesh), {}, {}, 0};
}

}  // namespace

const char* name_of(Truth truth) {
  const char* const names[] = {"dqs", "cor", "delta-mush", "examples"};
  return names[static_cast<std::size_t>(truth)];
}

deform::Deformer make_truth(const DeformSource& source, const LearnOptions& options) {
  switch (options.truth) {
    case Truth::dual_quaternions:
      return deform::dual_quaternions(source.mesh);
    case Truth::centres_of_rotation:
      return deform::centres_of_rotation(source.mesh);
    case Truth::delta_mush:
      return deform::delta_mush(source.mesh, options.delta_mush);
    case Truth::examples:
      break;
  }
  return as_shown(source.mesh, source.shown);
}

std::vector<ShownPose> find_examples(const LearnOptions& options, const Shown& shown, Notes& notes) {
  if (options.truth != Truth::examples) return {};
  return read_examples(options.examples_file, shown, notes.reads);
}

Trainees find_trainees(const DeformSource& source, const BuiltScene& built, const LearnOptions& options) {
  if (options.truth == Truth::examples) return trainees(source, source.shown);
  return trainees(source, built, clip_poses(built, source.skeleton, kTrainedRate_hz, kMostTrained), options.wide_poses);
}

Learnt learn(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options) {
  const deform::SkinnedMesh& mesh = source.mesh;
  const double size_m = deform::diagonal(mesh);
  if (options.animation_space == AnimationSpace::lift || mesh.positions.empty() || !(size_m > 0)) return as_it_is(mesh);
  Learnt out;
  if (options.animation_space == AnimationSpace::smooth) {
    out.coordinates = smoothed(mesh, options);
    return out;
  }
  deform::Coordinates candidates = make_candidates(mesh, options);
  if (options.half_joints > 0) {
    out.half_joints = deform::add_half_joints(source.parents, source.centres, options.half_joints, candidates);
    for (deform::TrainingPose& p : poses) deform::append_half_joints(out.half_joints, p.pose);
  }
  deform::FitOptions fit;
  fit.keep_bind_pose = options.keep_bind_pose;
  fit.kept = &mesh;
  fit.most_joints = most_joints(options);
  fit.progress = options.progress;
  deform::Fit fitted = deform::fit_coordinates(candidates, size_m, std::move(poses), make_truth(source, options),
                                               deform::ssd(mesh), fit);
  out.quality = fitted.quality;
  out.rms_m = fitted.rms * size_m;
  if (!(fitted.quality.share < 1)) {
    Learnt kept = as_it_is(mesh);
    kept.quality = fitted.quality;
    return kept;
  }
  out.coordinates = std::move(fitted.coordinates);
  return out;
}

namespace {

// The residual is what coordinates have beside the lift of the weights that SSD keeps.
BoundVertex with_residual(const BoundVertex& old, const std::vector<deform::Coordinate>& coordinates,
                          const glm::dvec3& v) {
  BoundVertex out;
  for (const deform::Coordinate& c : coordinates) out.push_back({c.joint, 0, c.q});
  for (const BoundInfluence& i : old) {
    const auto found = std::ranges::find(out, i.joint, &BoundInfluence::joint);
    if (found == out.end()) {
      out.push_back({i.joint, i.weight});
    } else {
      found->weight = i.weight;
    }
  }
  std::ranges::sort(out, {}, &BoundInfluence::joint);
  for (BoundInfluence& i : out) i.residual -= glm::dvec4(v, 1) * i.weight;
  return out;
}

// step_m: how finely residuals are to be stored.
SkinBinding with_learnt(SkinBinding binding, const DeformSource& source, const Learnt& learnt, double step_m) {
  binding.half_joints = learnt.half_joints;
  binding.residual_step_m = step_m;
  // A weight moves a vertex by at most how far joints take it apart: about a tenth of the size.
  binding.residual_weight_step = step_m / (0.1 * deform::diagonal(source.mesh));
  for (std::size_t p = 0; p < binding.primitives.size(); ++p)
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      const std::uint32_t welded = source.vertex_of[p][v];
      binding.primitives[p][v] =
          with_residual(binding.primitives[p][v], learnt.coordinates[welded], source.mesh.positions[welded]);
    }
  return binding;
}

}  // namespace

LearntBinding learn_binding(const RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                            const LearnOptions& given, SkinBinding binding, Notes& notes) {
  LearnReport report;
  if (given.animation_space == AnimationSpace::lift) return {std::move(binding), report};
  DeformSource source = deform_source(mesh, skin, binding, built);
  const std::string pointer = mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer;
  const LearnOptions options = with_gentle_steps(given, source.mesh, pointer, notes);
  const bool fits = options.animation_space == AnimationSpace::fit;
  Trainees trained;
  if (fits) {
    source.shown = find_examples(options, {scene, mesh, skin, built, source}, notes);
    trained = find_trainees(source, built, options);
    drop_spoilt_poses(scene, skin, source.mesh, options.truth, pointer, trained.poses, notes);
    report.truth = name_of(options.truth);
  }
  report.poses = trained.poses.size();
  report.made_up = trained.made_up;
  const Learnt learnt = learn(source, std::move(trained.poses), options);
  report.held_out_share = learnt.quality.share;
  report.worse_share = learnt.quality.worse_share;
  if (fits && !(learnt.quality.share < 1)) {
    notes.warnings.push_back({pointer, "fit-not-better",
                              "animation space fitted to " + std::string(report.truth) +
                                  " is no better than linear blend skinning in poses left out; the lift is shipped"});
    return {std::move(binding), report};
  }
  if (!fits || options.truth == Truth::delta_mush)
    binding.residual_source = {options.delta_mush.iterations, options.delta_mush.step, !fits};
  report.kind = fits ? "fit" : "smooth";
  report.half_joints = learnt.half_joints.size();
  const double size_m = deform::diagonal(source.mesh);
  return {with_learnt(std::move(binding), source, learnt, std::max(fits ? learnt.rms_m / 2 : 0, size_m / 16384)),
          report};
}

}  // namespace marrow::cook
