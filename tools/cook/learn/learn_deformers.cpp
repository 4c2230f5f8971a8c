#include "cook/learn/learn_deformers.h"

#include <algorithm>

#include "deform/half_joints.h"

namespace marrow::cook {
namespace {

// The binding with the influences and weights that quantisation leaves; a mesh that is not packed keeps all.
SkinBinding as_kept(const RawMesh& mesh, const SkinBinding& binding, const MeshGrid& grid, const CookOptions& options) {
  SkinBinding out = binding;
  if (options.mesh_codec == MeshCodec::none) return out;
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
bool judge(const deform::FitQuality& quality, const char* what, const std::string& pointer, RawScene& scene,
           DeformerReport& report) {
  report.held_out_share = quality.share;
  report.worse_share = quality.worse_share;
  report.shipped = quality.share < 1;
  if (!report.shipped)
    scene.warnings.push_back({pointer, "fit-not-better",
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

void learn_deformers(RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                     const CookOptions& options, MeshGrid grid, SkinBinding& binding, LearnReport& report) {
  const LearnOptions& learn = options.learn;
  if (!learn.multi_weights && learn.pose_examples == 0) return;
  grid.residual_step = binding.residual_step_m;
  grid.residual_weight_step = binding.residual_weight_step;
  DeformSource source = deform_source(mesh, skin, as_kept(mesh, binding, grid, options), built);
  Trainees trained = find_trainees(scene, mesh, skin, built, learn, source);
  for (deform::TrainingPose& p : trained.poses) deform::append_half_joints(binding.half_joints, p.pose);
  source.parents.resize(source.parents.size() + binding.half_joints.size(), kNone);
  DeformSource weighted = source;
  weighted.mesh = weighted_only(source.mesh);
  const deform::Deformer truth = make_truth(weighted, learn);
  const std::string pointer = mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer;
  BoundDeformers& out = binding.deformers;
  out.vertex_of = source.vertex_of;
  if (learn.multi_weights) {
    report.multi_weights = begin_report(learn, trained);
    out.root = multi_weight_root(source);
    deform::MultiWeightOptions with;
    with.progress = learn.progress;
    deform::MultiWeightFit fit = deform::fit_multi_weights(source.mesh, out.root, trained.poses, truth, with);
    if (judge(fit.quality, "multi-weight enveloping", pointer, scene, report.multi_weights))
      out.multi_weights = std::move(fit.weights);
  }
  if (learn.pose_examples > 0) {
    report.pose_space = begin_report(learn, trained);
    deform::PoseSpaceOptions with;
    with.most_examples = static_cast<std::size_t>(learn.pose_examples);
    with.progress = learn.progress;
    deform::PoseSpaceFit fit = deform::fit_pose_space(weighted.mesh, source.parents, trained.poses, truth, with);
    if (judge(fit.quality, "pose-space deformation", pointer, scene, report.pose_space))
      out.pose_space = std::move(fit.space);
    report.pose_space.examples = out.pose_space.examples.size();
  }
}

std::vector<std::uint32_t> joints_of_deformers(const BoundDeformers& deformers, const BoundVertex& vertex) {
  std::vector<std::uint32_t> out;
  if (!deformers.multi_weights.empty()) out.push_back(deformers.root);
  if (deformers.pose_space.examples.empty()) return out;
  for (const BoundInfluence& i : vertex)
    if (i.weight > 0 && deformers.pose_space.parents[i.joint] != kNone)
      out.push_back(static_cast<std::uint32_t>(deformers.pose_space.parents[i.joint]));
  return out;
}

namespace {

MultiWeightData multi_weight_data(const BoundDeformers& deformers, const std::vector<std::uint32_t>& vertex_of,
                                  const std::vector<BoundVertex>& vertices,
                                  const std::vector<std::uint16_t>& entry_of) {
  MultiWeightData out;
  out.root = entry_of[deformers.root];
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::vector<deform::MultiWeight>& learnt = deformers.multi_weights[vertex_of[v]];
    auto& to = out.weights.emplace_back();
    for (const BoundInfluence& i : vertices[v]) {
      auto& twelve = to.emplace_back();  // zeros for what quantisation drops
      const auto found = std::ranges::find(learnt, i.joint, &deform::MultiWeight::joint);
      for (std::size_t n = 0; n < 12 && found != learnt.end(); ++n)
        twelve[n] = found->rows[n / 4][static_cast<int>(n % 4)];
    }
  }
  return out;
}

PoseSpaceData pose_space_data(const deform::PoseSpace& space, const std::vector<std::uint32_t>& vertex_of,
                              const std::vector<BoundVertex>& vertices, const std::vector<std::uint16_t>& entry_of,
                              std::size_t palette_size) {
  PoseSpaceData out;
  out.sigma = space.sigma;
  out.parents.assign(palette_size, kNoParent);
  std::vector<std::uint32_t> joint_of(palette_size, 0);
  for (const BoundVertex& vertex : vertices)
    for (const BoundInfluence& i : vertex) {
      if (!(i.weight > 0) || space.parents[i.joint] == kNone) continue;
      out.parents[entry_of[i.joint]] = entry_of[static_cast<std::size_t>(space.parents[i.joint])];
      joint_of[entry_of[i.joint]] = i.joint;
    }
  for (const deform::PoseSpaceExample& from : space.examples) {
    PoseSpaceData::Example& e = out.examples.emplace_back();
    for (std::size_t entry = 0; entry < palette_size; ++entry)
      e.rotations.push_back(out.parents[entry] == kNoParent ? glm::dquat(1, 0, 0, 0) : from.rotations[joint_of[entry]]);
    for (const std::uint32_t v : vertex_of) e.deltas.push_back(from.deltas[v]);
  }
  return out;
}

}  // namespace

DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size) {
  const BoundDeformers& from = binding.deformers;
  const std::vector<BoundVertex>& vertices = binding.primitives[primitive];
  DeformerData out;
  if (!from.multi_weights.empty())
    out.multi_weight = multi_weight_data(from, from.vertex_of[primitive], vertices, entry_of);
  if (!from.pose_space.examples.empty())
    out.pose_space = pose_space_data(from.pose_space, from.vertex_of[primitive], vertices, entry_of, palette_size);
  return out;
}

}  // namespace marrow::cook
