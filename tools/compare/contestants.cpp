#include "compare/contestants.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include "cook/learn/learn_deformers.h"
#include "deform/deformers.h"
#include "deform/fit/eigen_skin.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "deform/fit/refit.h"

namespace marrow::tools {
namespace {

using cook::AnimationSpace;
using cook::LearnOptions;
using deform::Pose;
using deform::Positions;
using deform::SkinnedMesh;

constexpr int kPoseExamples = 8;

// A copy, as training may go before the study.
Trained by_weights(const SkinnedMesh& mesh) {
  const auto kept = std::make_shared<const SkinnedMesh>(mesh);
  Trained out;
  out.deform = [kept, deformer = deform::ssd(*kept)](const Pose& pose, Positions& to) { deformer(pose, to); };
  out.blend = mesh.influences;
  out.extend = [](const Pose& pose) { return pose; };
  return out;
}

SkinnedMesh follows_one_joint(SkinnedMesh mesh) {
  for (std::vector<deform::Influence>& influences : mesh.influences) {
    const auto most = std::ranges::max_element(influences, {}, &deform::Influence::weight);
    influences = {{most->joint, 1.0}};
  }
  return mesh;
}

// Normals are those of the triangles that it makes.
Trained by_joint_operators(const Study& study) {
  const SkinnedMesh& mesh = study.source.mesh;
  Trained out = by_weights(follows_one_joint(mesh));
  out.deform = deform::joint_operators(mesh, study.source.parents, study.source.centres);
  out.normals = [&mesh, deformer = out.deform](const Pose& pose) {
    Positions positions;
    deformer(pose, positions);
    return deform::vertex_normals(positions, mesh.indices);
  };
  return out;
}

Trained by_coordinates(const SkinnedMesh& mesh, cook::Learnt learnt) {
  const auto kept = std::make_shared<const cook::Learnt>(std::move(learnt));
  Trained out;
  out.extend = [kept](Pose pose) {
    deform::append_helpers(kept->helpers, pose);
    return pose;
  };
  out.deform = [kept, extend = out.extend, deformer = deform::animation_space(kept->coordinates)](
                   const Pose& pose, Positions& to) { deformer(extend(pose), to); };
  for (const auto& vertex : kept->coordinates) {
    std::vector<deform::Influence>& blend = out.blend.emplace_back();
    for (const deform::Coordinate& c : vertex) blend.push_back({c.joint, c.q.w});
  }
  out.tangents = deform::tangent_coordinates(kept->coordinates, mesh,
                                             deform::vertex_normals(mesh.positions, mesh.indices), kept->helpers);
  return out;
}

// Normals go through linear blend skinning's matrices, as the runtime's do.
Trained by_multi_weights(const Study& study, const Round& round, const deform::Deformer& truth) {
  const SkinnedMesh& mesh = study.source.mesh;
  const std::uint32_t root = cook::multi_weight_root(study.source);
  const auto fit =
      std::make_shared<const deform::MultiWeightFit>(deform::fit_multi_weights(mesh, root, round.train, truth));
  Trained out = by_weights(mesh);
  out.deform = [fit, deformer = deform::multi_weight(mesh, fit->weights, root)](const Pose& pose, Positions& to) {
    deformer(pose, to);
  };
  return out;
}

Trained in_pose_space(const Study& study, const Round& round, const deform::Deformer& truth) {
  const SkinnedMesh& mesh = study.source.mesh;
  deform::PoseSpaceOptions most;
  most.most_examples = kPoseExamples;
  const auto fit = std::make_shared<const deform::PoseSpaceFit>(
      deform::fit_pose_space(mesh, study.source.parents, round.train, truth, most));
  Trained out = by_weights(mesh);
  out.deform = [fit, deformer = deform::pose_space(mesh, fit->space)](const Pose& pose, Positions& to) {
    deformer(pose, to);
  };
  return out;
}

Trained by_eigen_skin(const Study& study, const Round& round, const deform::Deformer& truth, int fields) {
  const SkinnedMesh& mesh = study.source.mesh;
  deform::EigenSkinOptions most;
  most.most_fields = static_cast<std::size_t>(fields);
  const auto skin = std::make_shared<const deform::EigenSkin>(
      deform::fit_eigen_skin(mesh, study.source.parents, study.source.centres, round.train, truth, most));
  Trained out = by_weights(mesh);
  out.deform = [skin, deformer = deform::eigen_skin(mesh, *skin)](const Pose& pose, Positions& to) {
    deformer(pose, to);
  };
  out.displacements = deform::displacements_per_vertex(mesh, *skin);
  return out;
}

LearnOptions with(LearnOptions options, AnimationSpace kind, int helpers, int influences = 0) {
  options.animation_space = kind;
  options.helpers = helpers;
  if (influences > 0) options.influences = influences;
  return options;
}

Contestant in_animation_space(const std::string& name, const LearnOptions& options) {
  Contestant out;
  out.name = name;
  out.cooked = options;
  out.kernel = Contestant::Kernel::as;
  out.train = [options](const Study& study, const Round& round, const LearnOptions&) {
    return by_coordinates(study.source.mesh, cook::learn(study.source, round.train, options));
  };
  return out;
}

}  // namespace

glm::dvec3 blended_normal(const std::vector<deform::Influence>& blend, const Pose& extended,
                          const glm::dvec3& bind_normal) {
  glm::dmat3 matrix(0);
  for (const deform::Influence& i : blend) matrix += deform::linear_of(extended[i.joint]) * i.weight;
  const glm::dvec3 n = glm::inverseTranspose(matrix) * bind_normal;
  const double length = glm::length(n);
  return length > 0 && std::isfinite(length) ? n / length : glm::dvec3(0);
}

std::vector<glm::dvec3> shading_normals(const Trained& trained, const std::vector<glm::dvec3>& bind_normals,
                                        const Pose& pose) {
  if (trained.normals) return trained.normals(pose);
  const Pose extended = trained.extend(pose);
  std::vector<glm::dvec3> out;
  for (std::size_t v = 0; v < bind_normals.size(); ++v)
    out.push_back(blended_normal(trained.blend[v], extended, bind_normals[v]));
  return out;
}

namespace {

// Segments, then weights.
std::vector<Contestant> first_contestants(const LearnOptions& lift) {
  Contestant rigid;
  rigid.name = "rigid";
  rigid.cooked = lift;
  rigid.kernel = Contestant::Kernel::rigid;
  rigid.train = [](const Study& study, const Round&, const LearnOptions&) {
    return by_weights(follows_one_joint(study.source.mesh));
  };
  Contestant stitched = rigid, joint_local = rigid;
  stitched.name = "stitched";
  stitched.can_be_cooked = false;
  stitched.train = [](const Study& study, const Round&, const LearnOptions&) {
    return by_weights(deform::stitched(study.source.mesh));
  };
  joint_local.name = "joint_local";
  joint_local.can_be_cooked = false;
  joint_local.train = [](const Study& study, const Round&, const LearnOptions&) { return by_joint_operators(study); };
  Contestant ssd;
  ssd.name = "ssd";
  ssd.cooked = lift;
  ssd.train = [](const Study& study, const Round&, const LearnOptions&) { return by_weights(study.source.mesh); };
  Contestant refit = ssd;
  refit.name = "ssd_refit";
  refit.can_be_cooked = false;
  refit.train = [](const Study& study, const Round& round, const LearnOptions& o) {
    return by_weights(deform::refit_weights(study.source.mesh, round.train, cook::make_truth(study.source, o)));
  };
  return {rigid, stitched, joint_local, ssd, refit};
}

// Beside SSD's weights.
std::vector<Contestant> last_contestants(const LearnOptions& lift, int eigen_fields) {
  Contestant mwe, psd;
  mwe.name = "mwe";
  mwe.cooked = lift;
  mwe.cooked.multi_weights = true;
  mwe.kernel = Contestant::Kernel::mwe;
  mwe.train = [](const Study& study, const Round& round, const LearnOptions& o) {
    return by_multi_weights(study, round, cook::make_truth(study.source, o));
  };
  psd.name = "psd";
  psd.cooked = lift;
  psd.cooked.pose_examples = kPoseExamples;
  psd.kernel = Contestant::Kernel::psd;
  psd.train = [](const Study& study, const Round& round, const LearnOptions& o) {
    return in_pose_space(study, round, cook::make_truth(study.source, o));
  };
  if (lift.truth == cook::Truth::examples) return {mwe, psd};
  Contestant eigen;
  eigen.name = "eigenskin";
  eigen.can_be_cooked = false;
  eigen.train = [eigen_fields](const Study& study, const Round& round, const LearnOptions& o) {
    return by_eigen_skin(study, round, cook::make_truth(study.source, o), eigen_fields);
  };
  return {mwe, psd, eigen};
}

}  // namespace

bool is_before_ssd(const std::string& deformer) {
  return deformer == "rigid" || deformer == "stitched" || deformer == "joint_local";
}

std::vector<Contestant> contestants(const LearnOptions& options, int eigen_fields) {
  const LearnOptions lift = with(options, AnimationSpace::lift, 0);
  std::vector<Contestant> out = first_contestants(lift);
  const auto add = [&](const char* name, const LearnOptions& how) { out.push_back(in_animation_space(name, how)); };
  add("as_lift", lift);
  add("as_smooth", with(options, AnimationSpace::smooth, 0));
  add("as_fit", with(options, AnimationSpace::fit, 0));
  add("as_helpers", with(options, AnimationSpace::lift, options.helpers));
  add("as_helpers_fit4", with(options, AnimationSpace::fit, options.helpers, 4));
  add("as_helpers_fit5", with(options, AnimationSpace::fit, options.helpers, 5));
  for (const Contestant& c : last_contestants(lift, eigen_fields)) out.push_back(c);
  return out;
}

}  // namespace marrow::tools
