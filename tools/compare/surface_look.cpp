#include "compare/surface_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "common/check_status.h"
#include "common/parallel.h"
#include "cook/scene/views.h"
#include "deform/look/folds.h"
#include "deform/surface.h"
#include "marrow/sample.h"

namespace marrow::tools {
namespace {

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

constexpr std::size_t kMostMoments = 16;
constexpr float kFrame_s = 1.0f / 60;

std::vector<const HeldPose*> worst_moments(const Study& study, const std::vector<double>& errors) {
  std::vector<std::pair<double, const HeldPose*>> all;
  const std::vector<HeldPose>& held = study.rounds.front().held;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i].number && study.built.clips[*held[i].number].duration_s >= 2 * kFrame_s)
      all.emplace_back(-errors[i], &held[i]);
  std::ranges::stable_sort(all, {}, &std::pair<double, const HeldPose*>::first);
  std::vector<const HeldPose*> out;
  for (std::size_t i = 0; i < std::min(kMostMoments, all.size()); ++i) out.push_back(all[i].second);
  return out;
}

std::array<deform::Pose, 3> frames_around(const Study& study, const HeldPose& moment) {
  const cook::BuiltSkeleton& built = study.built.skeletons[study.source.skeleton];
  const cook::BuiltClip& of = study.built.clips[*moment.number];
  const Skeleton skeleton = view(built);
  const Clip clip = view(of, skeleton);
  const float middle = std::clamp(static_cast<float>(moment.time_s), kFrame_s, of.duration_s - kFrame_s);
  std::array<deform::Pose, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<SoaTransform> local(skeleton.soa_size());
    check(sample(skeleton, clip, middle + (static_cast<float>(i) - 1) * kFrame_s, local));
    out[i] = cook::deform_pose(study.source, built, local);
  }
  return out;
}

}  // namespace

Shape::Shape(const deform::SkinnedMesh& m) : mesh(m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    const auto [at, is_new] = first.try_emplace(std::minmax(a, b), i / 3);
    if (!is_new) hinges.emplace_back(at->second, i / 3);
  }
  bind_normals = deform::vertex_normals(mesh.positions, mesh.indices);
  bind_angles = angles(mesh.positions);
  for (const double angle : bind_angles) bind_turns_.emplace_back(std::cos(angle), std::sin(angle));
}

std::vector<glm::dvec3> Shape::normals(const deform::Positions& p) const {
  std::vector<glm::dvec3> out;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::dvec3 n =
        glm::cross(p[mesh.indices[t + 1]] - p[mesh.indices[t]], p[mesh.indices[t + 2]] - p[mesh.indices[t]]);
    const double length = glm::length(n);
    out.push_back(length > 0 ? n / length : glm::dvec3(0));
  }
  return out;
}

std::vector<double> Shape::angles(const deform::Positions& p) const {
  const std::vector<glm::dvec3> of = normals(p);
  std::vector<double> out;
  for (const auto& [a, b] : hinges)
    out.push_back(of[a] == glm::dvec3(0) || of[b] == glm::dvec3(0) ? 0.0 : angle_between(of[a], of[b]));
  return out;
}

// A hinge that is folded less than the sharpest so far shows that by the cosine alone.
double Shape::sharpest_rad(const deform::Positions& p) const {
  constexpr double kUnsure = 1e-9;
  const std::vector<glm::dvec3> of = normals(p);
  double out = 0, cosine = 1, sine = 0;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const auto [a, b] = hinges[h];
    if (of[a] == glm::dvec3(0) || of[b] == glm::dvec3(0) || bind_angles[h] + out >= std::numbers::pi) continue;
    const auto [bind_cosine, bind_sine] = bind_turns_[h];
    if (glm::dot(of[a], of[b]) > bind_cosine * cosine - bind_sine * sine + kUnsure) continue;
    const double beyond = angle_between(of[a], of[b]) - bind_angles[h];
    if (!(beyond > out)) continue;
    out = beyond;
    cosine = std::cos(out);
    sine = std::sin(out);
  }
  return out;
}

std::vector<std::optional<double>> largest_jumps(const Study& study, const std::vector<Trained>& deformers,
                                                 const deform::Deformer& truth,
                                                 const std::vector<double>& plain_error_of_pose) {
  const std::vector<const HeldPose*> moments = worst_moments(study, plain_error_of_pose);
  std::vector<std::vector<std::optional<double>>> jumps(moments.size());
  for_each_in_parallel(moments.size(), [&](std::size_t m) {
    const std::array<deform::Pose, 3> poses = frames_around(study, *moments[m]);
    for (std::size_t d = 0; d <= deformers.size(); ++d) {
      const deform::Deformer& deformer = d < deformers.size() ? deformers[d].deform : truth;
      std::array<deform::Positions, 3> at;
      bool is_known = true;
      for (std::size_t i = 0; i < 3; ++i) {
        deformer(poses[i], at[i]);
        is_known = is_known && deform::is_finite(at[i]);
      }
      jumps[m].push_back(is_known ? std::optional(deform::largest_jump(study.source.mesh, poses, at)) : std::nullopt);
    }
  });
  std::vector<std::optional<double>> out(deformers.size() + 1);
  for (std::size_t d = 0; d < out.size(); ++d) {
    const bool is_known = std::ranges::all_of(jumps, [&](const auto& of) { return of[d].has_value(); });
    for (std::size_t m = 0; is_known && m < jumps.size(); ++m) out[d] = std::max(out[d].value_or(0), *jumps[m][d]);
  }
  return out;
}

}  // namespace marrow::tools
