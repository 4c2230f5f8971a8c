#include "cook/learn/truths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "common/evenly.h"
#include "cook/learn/examples.h"
#include "deform/deformers.h"
#include "deform/elastic/elastic.h"
#include "deform/rotations.h"

namespace marrow::cook {
namespace {

// A truth is a deformer of a mesh. A new one is a line here and in enum Truth, and a name among the options.
struct TruthKind {
  Truth truth;
  const char* name;
  deform::Deformer (*make)(const DeformSource& source, const LearnOptions& options);  // refers to the source
};
using Source = const DeformSource&;
using Options = const LearnOptions&;

constexpr TruthKind kTruths[] = {
    {Truth::dual_quaternions, "dqs", [](Source s, Options) { return deform::dual_quaternions(s.mesh); }},
    {Truth::centres_of_rotation, "cor", [](Source s, Options) { return deform::centres_of_rotation(s.mesh); }},
    {Truth::delta_mush, "delta-mush", [](Source s, Options o) { return deform::delta_mush(s.mesh, o.delta_mush); }},
    {Truth::delta_mush_over_dqs, "delta-mush-dqs",
     [](Source s, Options o) { return deform::delta_mush(s.mesh, o.delta_mush, deform::dual_quaternions(s.mesh)); }},
    {Truth::elastic, "elastic",
     [](Source s, Options o) { return s.elastic ? s.elastic : deform::elastic(s.mesh, o.elastic); }},
    {Truth::examples, "examples", [](Source s, Options) { return as_shown(s.mesh, s.shown); }},
};

const TruthKind& kind_of(Truth truth) {
  return *std::ranges::find(kTruths, truth, &TruthKind::truth);
}

bool is_finite(const deform::Matrix& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

}  // namespace

const char* name_of(Truth truth) {
  return kind_of(truth).name;
}

deform::Deformer make_truth(const DeformSource& source, const LearnOptions& options) {
  return kind_of(options.truth).make(source, options);
}

void remember_truth(const LearnOptions& options, const RawScene& scene, const RawSkin& skin, const RawMesh& mesh,
                    DeformSource& source, Notes& notes, std::size_t most_bytes) {
  if (options.truth != Truth::elastic) return;
  if (options.known_elastic) {
    source.elastic = options.known_elastic;
    return;
  }
  std::vector<deform::Pose> poses;
  for (const deform::MotionPose& turned : tools::evenly(source.motion, kLookedAt)) poses.push_back(turned.pose());
  std::vector<double> rig_shares;
  source.elastic = deform::remembered(deform::elastic(source.mesh, options.elastic, poses, &rig_shares), most_bytes);
  note_stiff_parts(scene, skin, mesh, source.mesh, rig_shares, notes);
}

LearnOptions with_gentle_steps(LearnOptions options, const deform::SkinnedMesh& mesh, const std::string& pointer,
                               Notes& notes) {
  const bool learns = options.animation_space == AnimationSpace::fit || options.multi_weights || options.pose_examples;
  if (options.animation_space != AnimationSpace::smooth && !(learns && smooths(options.truth))) return options;
  const double kept = deform::area_kept(mesh, options.delta_mush);
  if (kept >= deform::kLeastArea) return options;
  options.delta_mush = deform::with_least_area(mesh, options.delta_mush);
  notes.warnings.push_back(
      {pointer, "delta-mush-shrinks",
       fmt::format(
           "smoothing leaves {:.0f} % of the mesh's area; its steps are shortened to {:.3g}, which leave {:.0f} "
           "%; fewer iterations (--delta-mush) or more triangles on thin parts are better",
           100 * kept, options.delta_mush.step, 100 * deform::area_kept(mesh, options.delta_mush))});
  return options;
}

UsablePoses::UsablePoses(const deform::SkinnedMesh& mesh, Truth truth)
    : followed_(mesh.joint_count, 0), shared_(mesh.joint_count, 0), blends_rotations_(blends_rotations(truth)) {
  for (const std::vector<deform::Influence>& influences : mesh.influences)
    for (const deform::Influence& i : influences) {
      if (i.joint >= mesh.joint_count) continue;
      followed_[i.joint] = 1;
      if (influences.size() > 1) shared_[i.joint] = 1;
    }
}

std::optional<std::uint32_t> UsablePoses::spoiling_joint(const deform::Pose& pose) const {
  for (std::uint32_t j = 0; j < followed_.size(); ++j) {
    if (!followed_[j]) continue;
    if (!is_finite(pose[j])) return j;
    if (blends_rotations_ && shared_[j] && !deform::has_rotation(deform::linear_of(pose[j]))) return j;
  }
  return std::nullopt;
}

namespace {

// "a", "b" and "c": of the joints the three at most that have the most, and at least a quarter of that.
std::string names_of_most(const RawScene& scene, const RawSkin& skin, const std::vector<double>& of_joint) {
  constexpr std::size_t kMost = 3;
  constexpr double kLeastShare = 0.25;
  std::vector<std::size_t> order(of_joint.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t j) { return of_joint[j]; });
  std::vector<std::string> names;
  for (const std::size_t j : order)
    if (names.size() < kMost && of_joint[j] >= kLeastShare * of_joint[order.front()])
      names.push_back('"' + scene.nodes[static_cast<std::size_t>(skin.joints[j])].name + '"');
  std::string out = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) out += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

}  // namespace

void note_stiff_parts(const RawScene& scene, const RawSkin& skin, const RawMesh& raw, const deform::SkinnedMesh& mesh,
                      const std::vector<double>& rig_shares, Notes& notes) {
  constexpr double kMany = 0.02;  // of the vertices
  std::vector<double> of_joint(mesh.joint_count, 0);
  double all = 0;
  for (std::size_t v = 0; v < rig_shares.size(); ++v) {
    all += rig_shares[v];
    for (const deform::Influence& i : mesh.influences[v]) of_joint[i.joint] += i.weight * rig_shares[v];
  }
  const double share = all / std::max(1.0, static_cast<double>(rig_shares.size()));
  if (!(share > kMany)) return;
  notes.warnings.push_back(
      {raw.primitives.empty() ? "/meshes" : raw.primitives.front().pointer, "elastic-not-everywhere",
       fmt::format("{:.0f} % of the mesh \"{}\", most about {}, keeps to dual quaternions: there it has no inside, or "
                   "surfaces that follow other joints lie within a cell",
                   100 * share, raw.name, names_of_most(scene, skin, of_joint))});
}

void drop_spoilt_poses(const RawScene& scene, const RawSkin& skin, const deform::SkinnedMesh& mesh, Truth truth,
                       const std::string& pointer, std::vector<deform::TrainingPose>& poses, Notes& notes) {
  const UsablePoses usable(mesh, truth);
  std::map<std::uint32_t, std::size_t> spoilt;  // by a joint
  const std::size_t all = poses.size();
  std::erase_if(poses, [&](const deform::TrainingPose& p) {
    const std::optional<std::uint32_t> joint = usable.spoiling_joint(p.pose);
    if (joint) ++spoilt[*joint];
    return joint.has_value();
  });
  if (spoilt.empty()) return;
  const auto most =
      std::ranges::max_element(spoilt, {}, [](const auto& joint_and_count) { return joint_and_count.second; });
  const std::string& name = scene.nodes[static_cast<std::size_t>(skin.joints[most->first])].name;
  const std::string others = spoilt.size() > 1 ? fmt::format(" (and {} more)", spoilt.size() - 1) : "";
  notes.warnings.push_back(
      {pointer, "joint-without-rotation",
       fmt::format("the joint \"{}\"{} has no rotation in {} of {} poses, as its scale is 0 or not finite; nothing is "
                   "learnt from them",
                   name, others, all - poses.size(), all)});
}

}  // namespace marrow::cook
