#include "commands/compare/motion/motion_pictures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <glm/geometric.hpp>
#include <glm/glm.hpp>

#include "commands/compare/stage.h"

namespace marrow::tools {
namespace {

constexpr int kSide = 600;

std::vector<std::size_t> worst_joints(const Study& study, const MotionStudy& motion, std::size_t deformer,
                                      std::size_t most) {
  std::vector<std::size_t> poses;
  for (std::size_t i = 0; i < motion.errors.size(); ++i)
    if (motion.errors[i].is_usable && motion.errors[i].truth_flipped == 0 &&
        std::isfinite(motion.errors[i].of[deformer].rms))
      poses.push_back(i);
  std::ranges::stable_sort(poses, std::greater<>(), [&](std::size_t i) { return motion.errors[i].of[deformer].rms; });
  std::vector<std::size_t> out;
  std::set<std::uint32_t> seen;
  for (const std::size_t i : poses)
    if (out.size() < most && seen.insert(study.motion.poses[i].joint).second) out.push_back(i);
  return out;
}

// How the character stands: the bind pose's frame may lie on its back.
deform::Matrix standing(const Study& study, std::uint32_t joint) {
  while (study.source.parents[joint] >= 0) joint = static_cast<std::uint32_t>(study.source.parents[joint]);
  return study.rest[joint];
}

deform::Pose placed(const deform::Matrix& by, deform::Pose pose) {
  for (deform::Matrix& m : pose) m = deform::Matrix(glm::dmat4(by) * glm::dmat4(m));
  return pose;
}

// How far from the joint the surface lies where the joint's part goes over into the rest: nine tenths of it.
double reach(const deform::SkinnedMesh& mesh, const deform::MotionPose& pose) {
  constexpr double kLeastShare = 0.1;
  const std::vector<double> shares = deform::turned_shares(mesh, *pose.turns);
  std::vector<double> distances;
  for (std::size_t v = 0; v < shares.size(); ++v)
    if (shares[v] > kLeastShare && shares[v] < 1 - kLeastShare)
      distances.push_back(glm::length(mesh.positions[v] - pose.centre));
  if (distances.empty()) return 0.1 * deform::diagonal(mesh);
  const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), at, distances.end());
  return std::max(*at, 0.01 * deform::diagonal(mesh));
}

// A bend is seen along its axis, a twist from where its bone lies across the picture; of both sides the one that is
// nearer to where characters are looked at from.
Orbit side_of(const deform::MotionPose& pose, const glm::dvec3& axis) {
  const Orbit usual;
  const glm::dvec3 from = {std::sin(usual.yaw) * std::cos(usual.pitch), std::sin(usual.pitch),
                           std::cos(usual.yaw) * std::cos(usual.pitch)};
  glm::dvec3 back = from - axis * glm::dot(from, axis);
  if (pose.kind != deform::MotionKind::twist) back = axis * (glm::dot(from, axis) < 0 ? -1.0 : 1.0) + from * 0.3;
  const double length = glm::length(back);
  if (!(length > 1e-6)) return usual;
  back /= length;
  Orbit out;
  out.yaw = static_cast<float>(std::atan2(back.x, back.z));
  out.pitch = static_cast<float>(std::clamp(std::asin(std::clamp(back.y, -1.0, 1.0)), -1.2, 1.2));
  return out;
}

Stage::View close_up(const deform::SkinnedMesh& mesh, const deform::MotionPose& pose, const deform::Matrix& placed,
                     const std::vector<PosedMesh>& truth) {
  constexpr double kAround = 1.3;
  const glm::dmat3 linear = deform::linear_of(placed);
  const glm::dvec3 axis = linear * pose.axis, centre = deform::transform(placed, pose.centre);
  const double radius = kAround * reach(mesh, pose) * glm::length(axis);
  Stage::View out = Stage::whole(truth);
  out.side = side_of(pose, glm::normalize(axis));
  out.framed.clear();
  for (int c = 0; c < 3; ++c)
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 arm(0);
      arm[c] = sign * radius;
      out.framed.emplace_back(centre + arm);
    }
  return out;
}

}  // namespace

std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers, std::size_t most) {
  std::vector<PictureRow> out;
  const std::vector<std::size_t> worst = worst_joints(study, motion, deformers.back(), most);
  if (worst.empty()) return out;
  Stage stage(study, kSide);
  for (const std::size_t i : worst) {
    const deform::MotionPose& pose = study.motion.poses[i];
    const deform::Matrix by = standing(study, pose.joint);
    PictureRow row;
    row.title = title_of(study, pose);
    const deform::Pose stands = placed(by, pose.pose());
    stage.draw({stands, truth, comparison, deformers},
               [&](const std::vector<PosedMesh>& t) { return close_up(study.source.mesh, pose, by, t); }, row);
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace marrow::tools
