#include "cook/learn/learn_deformers.h"

#include <algorithm>

#include "cook/learn/learn.h"
#include "cook/learn/truths.h"
#include "cook/skin/deform_source.h"
#include "deform/helpers/helpers.h"

namespace marrow::cook {
namespace {

// The binding with the influences and weights that quantisation leaves; a mesh that is not packed keeps all.
SkinBinding as_kept(const RawMesh& mesh, const SkinBinding& binding, const MeshGrid& grid, const MeshOptions& options) {
  SkinBinding out = binding;
  if (options.codec == MeshCodec::none) return out;
  for (std::size_t p = 0; p < out.primitives.size(); ++p)
    for (std::size_t v = 0; v < out.primitives[p].size(); ++v) {
      const BoundVertex& vertex = binding.primitives[p][v];
      Binding places;  // joints by their place in the vertex
      for (const BoundInfluence& i : vertex) {
        places.set.push_back(static_cast<std::uint16_t>(places.set.size()));
        places.weights.push_back(i.weight);
        if (binding.residual_step_m > 0) places.residual.push_back(i.residual);
      }
      const Binding kept = quantised_binding(places, mesh.primitives[p].positions[v], grid, options.precision);
      out.primitives[p][v].clear();
      for (std::size_t k = 0; k < kept.set.size(); ++k)
        out.primitives[p][v].push_back({vertex[kept.set[k]].joint, kept.weights[k]});
    }
  return out;
}

// Without influences of no weight, which SSD, pose space and truths do not know.
deform::SkinnedMesh weighted_only(deform::SkinnedMesh mesh) {
  for (std::vector<deform::Influence>& influences : mesh.influences)
    std::erase_if(influences, [](const deform::Influence& i) { return i.weight == 0; });
  return mesh;
}

DeformerReport begin_report(const LearnOptions& options, const Trainees& trained) {
  DeformerReport out;
  out.truth = name_of(options.truth);
  out.poses = trained.poses.size();
  out.made_up = trained.made_up;
  return out;
}

// Whether it is better than SSD.
bool judge(const deform::FitQuality& quality, const char* what, const std::string& pointer, DeformerReport& report,
           Notes& notes) {
  report.held_out_share = quality.share;
  report.worse_share = quality.worse_share;
  report.shipped = quality.share < 1;
  if (!report.shipped)
    notes.warnings.push_back({pointer, "fit-not-better",
                              std::string(what) + " learnt from " + report.truth +
                                  " is no better than linear blend skinning in poses left out; none is shipped"});
  return report.shipped;
}

}  // namespace

std::uint32_t multi_weight_root(const DeformSource& source) {
  std::uint32_t best = 0;
  bool any = false;
  for (const std::vector<deform::Influence>& influences : source.mesh.influences)
    for (const deform::Influence& i : influences) {
      if (i.joint >= source.joints.size() || (any && source.joints[i.joint] >= source.joints[best])) continue;
      best = i.joint;
      any = true;
    }
  return best;
}

LearntDeformers learn_deformers(const RawScene& scene, const RawMesh& mesh, const RawSkin& skin,
                                const BuiltScene& built, const MeshOptions& options, const LearnOptions& wanted,
                                MeshGrid grid, const SkinBinding& binding, Notes& notes) {
  LearntDeformers out;
  if (!wanted.multi_weights && wanted.pose_examples == 0) return out;
  grid.residual_step = binding.residual_step_m;
  grid.residual_weight_step = binding.residual_weight_step;
  DeformSource source = deform_source(mesh, skin, as_kept(mesh, binding, grid, options), built);
  const std::string pointer = mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer;
  // Where animation space is learnt from the truth as well, all has been said.
  Notes said;
  Notes& to_say = wanted.animation_space == AnimationSpace::fit ? said : notes;
  DeformSource original = source;  // what truths know: joints alone
  original.mesh = weighted_only(source.mesh);
  for (std::vector<deform::Influence>& influences : original.mesh.influences)
    influences = deform::on_joints(influences, binding.helpers, original.mesh.joint_count);
  const LearnOptions learn = with_gentle_steps(wanted, original.mesh, pointer, to_say);
  source.shown = find_examples(learn, {scene, mesh, skin, built, source});
  original.shown = source.shown;
  Trainees trained = find_trainees(source, built, learn);
  drop_spoilt_poses(scene, skin, original.mesh, learn.truth, pointer, trained.poses, to_say);
  for (deform::TrainingPose& p : trained.poses) deform::append_helpers(binding.helpers, p.pose);
  for (const deform::Helper& h : binding.helpers) source.parents.push_back(static_cast<int>(h.first));
  DeformSource weighted = source;
  weighted.mesh = weighted_only(source.mesh);
  if (learn.truth == Truth::elastic)
    original.motion = range_of_motion(original, built.skeletons[original.skeleton]).poses;
  remember_truth(learn, scene, skin, mesh, original, to_say);
  const deform::Deformer truth = make_truth(original, learn);
  out.deformers.vertex_of = source.vertex_of;
  if (learn.multi_weights) {
    out.multi_weights = begin_report(learn, trained);
    out.deformers.root = multi_weight_root(source);
    deform::MultiWeightOptions with;
    with.progress = notes.progress_of(Stage::learn);
    deform::MultiWeightFit fit = deform::fit_multi_weights(source.mesh, out.deformers.root, trained.poses, truth, with);
    if (judge(fit.quality, "multi-weight enveloping", pointer, out.multi_weights, notes))
      out.deformers.multi_weights = std::move(fit.weights);
  }
  if (learn.pose_examples > 0) {
    out.pose_space = begin_report(learn, trained);
    deform::PoseSpaceOptions with;
    with.most_examples = static_cast<std::size_t>(learn.pose_examples);
    with.progress = notes.progress_of(Stage::learn);
    deform::PoseSpaceFit fit = deform::fit_pose_space(weighted.mesh, source.parents, trained.poses, truth, with);
    if (judge(fit.quality, "pose-space deformation", pointer, out.pose_space, notes))
      out.deformers.pose_space = std::move(fit.space);
    out.pose_space.examples = out.deformers.pose_space.examples.size();
  }
  return out;
}

}  // namespace marrow::cook
