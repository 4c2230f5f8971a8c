#include "cook/learn/learn.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <glm/geometric.hpp>

#include "common/evenly.h"
#include "common/failure.h"
#include "cook/learn/kept_fit.h"
#include "cook/learn/look_better.h"
#include "cook/learn/trainees.h"
#include "cook/skin/deform_source.h"
#include "deform/deformers.h"
#include "deform/helpers/closed_form.h"
#include "deform/helpers/never_worse.h"
#include "deform/motion/motion_errors.h"
#include "deform/weights/auto_weights.h"
#include "deform/weights/edit_weights.h"
#include "marrow/file.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kSmoothed = 8;          // joints of smoothed weights
constexpr std::size_t kMostCandidates = 24;   // joints and helpers that a vertex chooses from
constexpr std::size_t kMostEntries = 341;     // what fits into a uniform block
constexpr std::size_t kVerticesAHelper = 16;  // so that posing helpers costs less than the vertices
// What helpers divide a pair of joints into: of `auto` no more than is worth its bytes.
constexpr int kQuarters = 4, kEighths = 8;
constexpr std::size_t kSingleJoints = 320;  // poses of them that a body learns

// Whether what is learnt is a body, which goes over from joint to joint more widely than weights do.
bool is_body(const LearnOptions& options) {
  return options.animation_space == AnimationSpace::fit && options.truth == Truth::elastic;
}

std::size_t most_joints(const LearnOptions& options) {
  if (options.influences > 0) return static_cast<std::size_t>(options.influences);
  return is_body(options) ? 6 : options.helpers != 0 ? 5 : 4;
}

// Of `auto` one a joint, more where there are vertices to pay for them, and no more than the palette has room for; of
// a body two a joint.
std::size_t most_helpers(const deform::SkinnedMesh& mesh, const LearnOptions& options) {
  if (options.helpers != kAutoHelpers) return static_cast<std::size_t>(options.helpers);
  std::set<std::uint32_t> joints;
  for (const std::vector<deform::Influence>& influences : mesh.influences)
    for (const deform::Influence& i : influences) joints.insert(i.joint);
  const std::size_t room = joints.size() < kMostEntries ? kMostEntries - joints.size() : joints.size();
  return std::min(
      room, is_body(options) ? joints.size() * 2 : std::max(joints.size(), mesh.positions.size() / kVerticesAHelper));
}

// The best guess without examples, over joints that a vertex may follow: to delta mush those that smoothing reaches, of
// which much is known in closed form; else its own.
deform::Coordinates guess(const deform::SkinnedMesh& mesh, const LearnOptions& options) {
  if (options.truth != Truth::delta_mush) return deform::lift(mesh);
  const deform::DeltaMushOptions& mush = options.delta_mush;
  deform::Coordinates out =
      deform::smoothed_ssd(mesh, deform::Surface(mesh, mush.weights), mush.iterations, mush.step, kSmoothed);
  for (std::size_t v = 0; v < out.size(); ++v) {
    for (const deform::Influence& i : mesh.influences[v])
      if (std::ranges::find(out[v], i.joint, &deform::Coordinate::joint) == out[v].end())
        out[v].push_back({i.joint, glm::dvec4(0)});
    std::ranges::sort(out[v], {}, &deform::Coordinate::joint);
  }
  return out;
}

// The mesh with its weights smoothed: what vertices may follow of a truth that goes over from joint to joint as bodies
// do.
deform::SkinnedMesh spread(deform::SkinnedMesh mesh) {
  constexpr int kSteps = 15;
  const std::vector<std::vector<deform::Influence>> own = mesh.influences;
  deform::smooth_weights(mesh.positions, mesh.indices, kSteps, mesh.influences);
  for (std::size_t v = 0; v < own.size(); ++v) {
    std::vector<deform::Influence>& vertex = mesh.influences[v];
    deform::keep_largest(vertex, kSmoothed, 0);
    for (const deform::Influence& i : own[v])
      if (std::ranges::find(vertex, i.joint, &deform::Influence::joint) == vertex.end()) vertex.push_back({i.joint, 0});
    std::ranges::sort(vertex, {}, &deform::Influence::joint);
  }
  return mesh;
}

// The mesh with the joints of `coordinates`.
deform::SkinnedMesh following(deform::SkinnedMesh mesh, const deform::Coordinates& coordinates) {
  for (std::size_t v = 0; v < coordinates.size(); ++v) {
    mesh.influences[v].clear();
    for (const deform::Coordinate& c : coordinates[v]) mesh.influences[v].push_back({c.joint, std::max(0.0, c.q.w)});
  }
  return mesh;
}

// Lets vertices follow helpers between their joints too: adds them as zeros.
void add_helpers(const deform::ClosedForm& form, deform::Coordinates& candidates) {
  for (std::size_t v = 0; v < candidates.size(); ++v) {
    for (const std::uint32_t entry : form.entries_of(v)) {
      if (candidates[v].size() >= kMostCandidates) break;
      if (std::ranges::find(candidates[v], entry, &deform::Coordinate::joint) == candidates[v].end())
        candidates[v].push_back({entry, glm::dvec4(0)});
    }
    std::ranges::sort(candidates[v], {}, &deform::Coordinate::joint);
  }
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
  return {deform::lift(mesh), mesh.influences, {}, {}, 0};
}

std::vector<deform::Pose> only_poses(const std::vector<deform::TrainingPose>& poses) {
  std::vector<deform::Pose> out;
  for (const deform::TrainingPose& p : poses) out.push_back(p.pose);
  return out;
}

// Of the range of motion the poses in which the truth is one: finite, and not folded.
std::vector<std::size_t> usable_motion(const DeformSource& source, const deform::Deformer& truth) {
  const std::vector<deform::MotionErrors> errors = deform::motion_errors(source.mesh, source.motion, truth, {});
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i].is_usable && errors[i].truth_flipped == 0) out.push_back(i);
  return out;
}

// Vertices that helpers would take farther from the truth than linear blend skinning follow their joints again: judged
// by the range of motion, and by `clips` where nothing was learnt from those.
void keep_ssd_where_worse(const DeformSource& source, const deform::Deformer& truth,
                          const std::vector<std::size_t>& motion, const std::vector<deform::Pose>& clips, Learnt& out) {
  constexpr std::size_t kMostPoses = 1024;
  const std::vector<std::size_t> looked_at = tools::evenly(motion, kMostPoses);
  const auto pose = [&](std::size_t i) {
    return i < clips.size() ? clips[i] : source.motion[looked_at[i - clips.size()]].pose();
  };
  const std::vector<char> goes_back =
      deform::better_by_ssd(source.mesh, out.coordinates, out.helpers, clips.size() + looked_at.size(), pose, truth);
  for (std::size_t v = 0; v < goes_back.size(); ++v) {
    if (goes_back[v] == 0) continue;
    out.weights[v] = source.mesh.influences[v];
    out.coordinates[v] = deform::lift(out.weights[v], source.mesh.positions[v]);
  }
}

}  // namespace

std::vector<ShownPose> find_examples(const LearnOptions& options, const Shown& shown) {
  if (options.truth != Truth::examples) return {};
  return read_examples(*options.examples, shown);
}

Trainees find_trainees(const DeformSource& source, const BuiltScene& built, const LearnOptions& options) {
  if (options.truth == Truth::examples) return trainees(source, source.shown);
  return trainees(source, built, clip_poses(built, source.skeleton, kTrainedRate_hz, kMostTrained), options.wide_poses);
}

namespace {

std::uint32_t folds_of(const std::vector<deform::TrainingPose>& poses) {
  std::uint32_t out = 1;
  for (const deform::TrainingPose& p : poses) out = std::max(out, p.fold + 1);
  return out;
}

// What is learnt of single joints, and what a fit is judged by beyond clips: of a body it learns those as well, and
// judges by its looks alone.
// motion: usable_motion() where it is judged by that.
void add_motion(const DeformSource& source, bool body, const std::vector<std::size_t>& motion,
                std::vector<deform::TrainingPose>& poses) {
  constexpr std::size_t kMostJudged = 512;
  if (body) {
    for (deform::TrainingPose& p : single_joints(source.motion, kSingleJoints, folds_of(poses)))
      poses.push_back(std::move(p));
  }
  for (const std::size_t i : tools::evenly(motion, kMostJudged))
    poses.push_back({source.motion[i].pose(), 0, false, false});
}

deform::FitOptions fit_options(const LearnOptions& options, const deform::ClosedForm& form,
                               const deform::Surface& surface, const deform::Progress& progress) {
  deform::FitOptions fit;
  // In most poses of a range of motion most of the mesh is as in the bind pose, where SSD is exact.
  fit.keep_bind_pose = options.keep_bind_pose || options.helpers != 0;
  fit.weights = &form;
  fit.is_lift = options.truth != Truth::delta_mush;
  fit.most_joints = most_joints(options);
  fit.progress = progress;
  if (!is_body(options)) return fit;
  constexpr double kUnseen = 1e-4;  // of the diagonal
  fit.ridges = {1e-4, 1e-5};
  fit.even_over = &surface;
  fit.unseen = kUnseen * kUnseen;
  return fit;
}

// Fits over `candidates`, with the closed form as the prior. Not better than SSD in what was left out: SSD's.
// out: has the helpers, which `form` refers to.
void fit_to(const DeformSource& source, const deform::Coordinates& candidates, const deform::ClosedForm& form,
            std::vector<deform::TrainingPose> poses, const deform::Deformer& truth, const LearnOptions& options,
            const deform::Progress& progress, Learnt& out) {
  const deform::SkinnedMesh& mesh = source.mesh;
  const double size_m = deform::diagonal(mesh);
  const bool body = is_body(options);
  std::vector<deform::Pose> clips;
  if (body) bring_to_bind_size(poses);
  if (body) clips = only_poses(poses);
  const deform::Surface surface(mesh);
  std::vector<std::size_t> motion;
  if (options.helpers != 0 && !body) motion = usable_motion(source, truth);
  add_motion(source, body, motion, poses);
  for (deform::TrainingPose& p : poses) deform::append_helpers(out.helpers, p.pose);
  deform::Fit fitted = deform::fit_coordinates(candidates, size_m, std::move(poses), truth, deform::ssd(mesh),
                                               fit_options(options, form, surface, progress));
  out.quality = fitted.quality;
  out.rms_m = fitted.rms * size_m;
  if (!(fitted.quality.share < 1)) {
    out = as_it_is(mesh);
    out.quality = fitted.quality;
    return;
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    out.weights[v] = form.weights_of(v, joints_of(fitted.coordinates[v])).value_or(mesh.influences[v]);
  out.coordinates = std::move(fitted.coordinates);
  if (body) {
    keep_from_looking_worse(source, form, clips, out);
    move_stiff_parts_as_one(mesh, out);
  } else {
    keep_ssd_where_worse(source, truth, motion, {}, out);
  }
}

}  // namespace

Learnt learn(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options,
             const deform::Progress& progress) {
  const deform::SkinnedMesh& mesh = source.mesh;
  Learnt out = as_it_is(mesh);
  if (mesh.positions.empty() || !(deform::diagonal(mesh) > 0)) return out;
  if (options.animation_space == AnimationSpace::smooth) {
    out.coordinates = smoothed(mesh, options);
    return out;
  }
  const bool fits = options.animation_space == AnimationSpace::fit;
  if (!fits && options.helpers == 0) return out;
  deform::Coordinates candidates = fits ? guess(mesh, options) : out.coordinates;
  const bool body = is_body(options);
  const deform::SkinnedMesh reach = body ? spread(mesh) : following(mesh, candidates);
  const std::vector<deform::Pose> clips = only_poses(poses);
  const deform::Likeness likeness(reach, clips, source.parents);
  // A body has helpers where no clip turns a joint, too.
  std::vector<deform::Pose> seen = clips;
  if (body)
    for (deform::TrainingPose& p : single_joints(source.motion, kSingleJoints, 1)) seen.push_back(std::move(p.pose));
  out.helpers = deform::choose_helpers(reach, deform::Likeness(reach, seen, source.parents), source.centres,
                                       most_helpers(mesh, options), options.truth == Truth::centres_of_rotation,
                                       options.helpers != kAutoHelpers ? kEighths : kQuarters);
  const deform::ClosedForm form(mesh, out.helpers, likeness);
  for (std::size_t v = 0; v < candidates.size(); ++v) {
    out.weights[v] = form.weights_of(v);
    if (!fits || options.truth != Truth::delta_mush) candidates[v] = deform::lift(out.weights[v], mesh.positions[v]);
  }
  const deform::Deformer truth = make_truth(source, options);
  if (fits) {
    add_helpers(deform::ClosedForm(reach, out.helpers, likeness), candidates);
    fit_to(source, candidates, form, std::move(poses), truth, options, progress, out);
    return out;
  }
  out.coordinates = std::move(candidates);
  keep_ssd_where_worse(source, truth, usable_motion(source, truth), clips, out);
  return out;
}

double residual_step_m(const Learnt& learnt, double size_m, const LearnOptions& options) {
  const double of_error = is_body(options) ? 1.0 / 3 : 0.5;
  return std::max(learnt.rms_m * of_error, size_m / 16384);
}

namespace {

// The residual is what coordinates have beside the lift of the weights.
BoundVertex bound(const std::vector<deform::Influence>& weights, const std::vector<deform::Coordinate>& coordinates,
                  const glm::dvec3& v, bool has_residual) {
  BoundVertex out;
  for (const deform::Influence& i : weights) out.push_back({i.joint, i.weight});
  if (!has_residual) return out;
  for (BoundInfluence& i : out) i.residual = -glm::dvec4(v, 1) * i.weight;
  for (const deform::Coordinate& c : coordinates) {
    const auto found = std::ranges::find(out, c.joint, &BoundInfluence::joint);
    if (found == out.end()) {
      out.push_back({c.joint, 0, c.q});
    } else {
      found->residual += c.q;
    }
  }
  std::ranges::sort(out, {}, &BoundInfluence::joint);
  return out;
}

// step_m: how finely residuals are to be stored; 0: there are none.
SkinBinding with_learnt(SkinBinding binding, const DeformSource& source, const Learnt& learnt, double step_m) {
  binding.helpers = learnt.helpers;
  binding.residual_step_m = step_m;
  // A weight moves a vertex by at most how far joints take it apart: about a tenth of the size.
  binding.residual_weight_step = step_m / (0.1 * deform::diagonal(source.mesh));
  for (std::size_t p = 0; p < binding.primitives.size(); ++p)
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      const std::uint32_t welded = source.vertex_of[p][v];
      binding.primitives[p][v] =
          bound(learnt.weights[welded], learnt.coordinates[welded], source.mesh.positions[welded], step_m > 0);
    }
  return binding;
}

// Of the helpers those that some vertex follows.
std::size_t helpers_followed(const SkinBinding& binding, std::size_t joint_count) {
  std::set<std::uint32_t> out;
  for (const std::vector<BoundVertex>& vertices : binding.primitives)
    for (const BoundVertex& vertex : vertices)
      for (const BoundInfluence& i : vertex)
        if (i.joint >= joint_count) out.insert(i.joint);
  return out.size();
}

}  // namespace

LearntBinding learn_binding(const RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                            const LearnOptions& given, SkinBinding binding, Notes& notes) {
  LearnReport report;
  const bool fits = given.animation_space == AnimationSpace::fit,
             smooths = given.animation_space == AnimationSpace::smooth;
  if (!fits && !smooths && given.helpers == 0) return {std::move(binding), report};
  DeformSource source = deform_source(mesh, skin, binding, built);
  const std::string pointer = mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer;
  const LearnOptions options = with_gentle_steps(given, source.mesh, pointer, notes);
  Trainees trained;
  if (!smooths) source.shown = find_examples(options, {scene, mesh, skin, built, source});
  if (!smooths) trained = find_trainees(source, built, options);
  if (fits) {
    drop_spoilt_poses(scene, skin, source.mesh, options.truth, pointer, trained.poses, notes);
    report.truth = name_of(options.truth);
  }
  if (!smooths) source.motion = range_of_motion(source, built.skeletons[source.skeleton]).poses;
  if (is_body(options)) source.frames = frames_in_a_row(source, built, kFramesInARow);
  if (fits) remember_truth(options, scene, skin, mesh, source, notes);
  report.poses = trained.poses.size();
  report.made_up = trained.made_up;
  const Learnt learnt = learn_or_find(source, std::move(trained.poses), options, notes);
  report.held_out_share = learnt.quality.share;
  report.worse_share = learnt.quality.worse_share;
  if (fits && !(learnt.quality.share < 1)) {
    notes.warnings.push_back({pointer, "fit-not-better",
                              "animation space fitted to " + std::string(report.truth) +
                                  " is no better than linear blend skinning in poses left out; the lift is shipped"});
    return {std::move(binding), report};
  }
  if (smooths || (fits && options.truth == Truth::delta_mush))
    binding.residual_source = {options.delta_mush.iterations, options.delta_mush.step, smooths};
  report.kind = fits ? "fit" : smooths ? "smooth" : "lift";
  const double step_m = fits || smooths ? residual_step_m(learnt, deform::diagonal(source.mesh), options) : 0;
  binding = with_learnt(std::move(binding), source, learnt, step_m);
  report.helpers = helpers_followed(binding, source.mesh.joint_count);
  return {std::move(binding), report};
}

}  // namespace marrow::cook
