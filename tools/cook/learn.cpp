#include "cook/learn.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "marrow/file.h"

namespace marrow::cook {
namespace {

constexpr double kRate_hz = 30;
constexpr std::size_t kMostPoses = 320;
constexpr std::size_t kMadeUp = 100;
constexpr std::uint32_t kMostFolds = 8;
constexpr std::size_t kInfluences = 4;  // of weights that are smoothed

// Poses of one clip are left out together; with one or two clips a quarter of a clip is.
std::uint32_t fold_of(const SampledPose& pose, const BuiltScene& built, std::size_t clip_count, std::uint32_t ordinal) {
  if (clip_count > 2) return ordinal % kMostFolds;
  const double duration = std::max(1e-6, static_cast<double>(built.clips[pose.clip].duration_s));
  const auto quarter = static_cast<std::uint32_t>(std::min(3.0, 4 * static_cast<double>(pose.time_s) / duration));
  return ordinal * 4 + quarter;
}

// How many influences each vertex of `follows` may have: those of the mesh that it lacks must still fit, for SSD.
std::vector<std::size_t> room_for(const deform::SkinnedMesh& follows, const deform::SkinnedMesh& mesh) {
  std::vector<std::size_t> out;
  for (std::size_t v = 0; v < mesh.influences.size(); ++v) {
    const auto lacks = std::ranges::count_if(mesh.influences[v], [&](const deform::Influence& i) {
      return std::ranges::find(follows.influences[v], i.joint, &deform::Influence::joint) ==
             follows.influences[v].end();
    });
    out.push_back(kMaxInfluences - static_cast<std::size_t>(lacks));
  }
  return out;
}

// Weights smoothed as delta mush smooths positions: those joints are what it follows. Beside `mesh`'s own at most
// kMaxInfluences in all.
deform::SkinnedMesh smoothed(const deform::SkinnedMesh& mesh, const deform::Surface& surface,
                             const deform::DeltaMushOptions& mush) {
  deform::SkinnedMesh out = deform::with_smoothed_weights(mesh, surface, mush.iterations, mush.step, kInfluences);
  const std::vector<std::size_t> room = room_for(out, mesh);
  for (std::size_t v = 0; v < room.size(); ++v)
    if (out.influences[v].size() > room[v]) out.influences[v] = mesh.influences[v];
  return out;
}

// Where the joints are the same, half-joints aside, what is known in closed form is a better start than the lift.
void start_from_smoothed(const deform::Coordinates& smoothed, deform::Coordinates& prior) {
  for (std::size_t v = 0; v < prior.size(); ++v) {
    std::vector<deform::Coordinate> start = prior[v];
    std::size_t found = 0;
    for (deform::Coordinate& c : start) {
      const auto known = std::ranges::find(smoothed[v], c.joint, &deform::Coordinate::joint);
      found += known != smoothed[v].end();
      c.q = known != smoothed[v].end() ? known->q : glm::dvec4(0);
    }
    if (found == smoothed[v].size()) prior[v] = std::move(start);
  }
}

Learnt as_it_is(const deform::SkinnedMesh& mesh) {
  return {deform::lift(mesh), {}, {}, 0};
}

}  // namespace

const char* name_of(Truth truth) {
  return truth == Truth::dual_quaternions ? "dqs" : truth == Truth::centres_of_rotation ? "cor" : "delta-mush";
}

deform::Deformer make_truth(const deform::SkinnedMesh& mesh, const LearnOptions& options) {
  switch (options.truth) {
    case Truth::dual_quaternions:
      return deform::dual_quaternions(mesh);
    case Truth::centres_of_rotation:
      return deform::centres_of_rotation(mesh);
    case Truth::delta_mush:
      break;
  }
  return deform::delta_mush(mesh, options.delta_mush);
}

Trainees trainees(const DeformSource& source, const BuiltScene& built) {
  const BuiltSkeleton& skeleton = built.skeletons[source.skeleton];
  const std::vector<SampledPose> sampled = clip_poses(built, source.skeleton, kRate_hz, kMostPoses);
  std::vector<std::uint32_t> clips;
  for (const SampledPose& pose : sampled)
    if (clips.empty() || clips.back() != pose.clip) clips.push_back(pose.clip);
  Trainees out;
  std::uint32_t folds = 1;
  for (const SampledPose& pose : sampled) {
    const auto ordinal = static_cast<std::uint32_t>(std::ranges::find(clips, pose.clip) - clips.begin());
    const std::uint32_t fold = fold_of(pose, built, clips.size(), ordinal);
    folds = std::max(folds, fold + 1);
    out.poses.push_back({deform_pose(source, skeleton, pose.local), fold, true});
  }
  if (sampled.empty()) folds = 5;
  std::uint32_t number = 0;
  for (const SampledPose& pose : resampled_poses(skeleton, sampled, kMadeUp))
    out.poses.push_back({deform_pose(source, skeleton, pose.local), number++ % folds, sampled.empty()});
  out.made_up = number;
  out.poses.push_back({deform::Pose(source.joints.size(), deform::Matrix(1.0)), 0, false});
  return out;
}

Learnt learn(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options) {
  const deform::SkinnedMesh& mesh = source.mesh;
  const double size_m = deform::diagonal(mesh);
  if (options.animation_space == AnimationSpace::lift || mesh.positions.empty() || !(size_m > 0)) return as_it_is(mesh);
  const deform::DeltaMushOptions& mush = options.delta_mush;
  const deform::Surface surface(mesh, mush.weights);
  Learnt out;
  if (options.animation_space == AnimationSpace::smooth) {
    out.coordinates = deform::smoothed_ssd(mesh, surface, mush.iterations, mush.step, kInfluences);
    const deform::Coordinates lifted = deform::lift(mesh);
    for (std::size_t v = 0; v < lifted.size(); ++v) {
      std::set<std::uint32_t> joints;
      for (const deform::Coordinate& c : lifted[v]) joints.insert(c.joint);
      for (const deform::Coordinate& c : out.coordinates[v]) joints.insert(c.joint);
      if (joints.size() > kMaxInfluences) out.coordinates[v] = lifted[v];
    }
    return out;
  }
  const deform::Deformer truth = make_truth(mesh, options), ssd = deform::ssd(mesh);
  deform::SkinnedMesh follows = mesh;
  if (options.truth == Truth::delta_mush) follows = smoothed(mesh, surface, mush);
  if (options.half_joints > 0) {
    deform::HalfJointMesh helped =
        deform::with_half_joints(follows, source.parents, source.centres, options.half_joints, room_for(follows, mesh));
    follows = std::move(helped.mesh);
    out.half_joints = std::move(helped.half_joints);
    for (deform::TrainingPose& p : poses) deform::append_half_joints(out.half_joints, p.pose);
  }
  deform::FitOptions fit;
  fit.keep_bind_pose = options.keep_bind_pose;
  fit.progress = options.progress;
  deform::Coordinates prior = deform::lift(follows);
  if (options.truth == Truth::delta_mush)
    start_from_smoothed(deform::smoothed_ssd(mesh, surface, mush.iterations, mush.step, kInfluences), prior);
  deform::Fit fitted = deform::fit_coordinates(prior, size_m, std::move(poses), truth, ssd, fit);
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

}  // namespace

LearnReport learn_binding(RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                          const LearnOptions& options, SkinBinding& binding) {
  LearnReport report;
  if (options.animation_space == AnimationSpace::lift) return report;
  const DeformSource source = deform_source(mesh, skin, binding, built);
  const bool fits = options.animation_space == AnimationSpace::fit;
  Trainees trained;
  if (fits) trained = trainees(source, built);
  report.poses = trained.poses.size();
  report.made_up = trained.made_up;
  const Learnt learnt = learn(source, std::move(trained.poses), options);
  if (fits) report.truth = name_of(options.truth);
  report.held_out_share = learnt.quality.share;
  report.worse_share = learnt.quality.worse_share;
  if (fits && !(learnt.quality.share < 1)) {
    scene.warnings.push_back({mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer, "fit-not-better",
                              "animation space fitted to " + std::string(report.truth) +
                                  " is no better than linear blend skinning in poses left out; the lift is shipped"});
    return report;
  }
  report.kind = fits ? "fit" : "smooth";
  report.half_joints = learnt.half_joints.size();
  binding.half_joints = learnt.half_joints;
  const double size_m = deform::diagonal(source.mesh);
  binding.residual_step_m = std::max(fits ? learnt.rms_m / 2 : 0, size_m / 16384);
  // A weight moves a vertex by at most how far joints take it apart: about a tenth of the size.
  binding.residual_weight_step = binding.residual_step_m / (0.1 * size_m);
  for (std::size_t p = 0; p < binding.primitives.size(); ++p)
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      const std::uint32_t welded = source.vertex_of[p][v];
      binding.primitives[p][v] =
          with_residual(binding.primitives[p][v], learnt.coordinates[welded], source.mesh.positions[welded]);
    }
  return report;
}

}  // namespace marrow::cook
