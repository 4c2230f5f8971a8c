#include "commands/compare/motion/motion_pictures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/glm.hpp>

#include "commands/compare/stage.h"

namespace marrow::tools {
namespace {

constexpr int kMotionSide = 620;  // as wide as the slider shows them

// Of those in which the truth does not fold the one with the largest error.
std::size_t farthest_pose(const MotionStudy& motion, std::size_t deformer) {
  std::size_t out = MotionRow::kNowhere;
  double most = 0;
  for (std::size_t i = 0; i < motion.errors.size(); ++i) {
    const deform::MotionErrors& errors = motion.errors[i];
    if (!errors.is_usable || errors.truth_flipped > 0 || !(errors.of[deformer].rms > most)) continue;
    most = errors.of[deformer].rms;
    out = i;
  }
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

Part part_of(const deform::SkinnedMesh& mesh, const deform::MotionPose& pose, const deform::Matrix& placed) {
  constexpr double kAround = 1.7;
  const glm::dvec3 axis = deform::linear_of(placed) * pose.axis, centre = deform::transform(placed, pose.centre);
  return {glm::vec3(centre), static_cast<float>(kAround * reach(mesh, pose) * glm::length(axis))};
}

}  // namespace

std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers) {
  std::vector<PictureRow> out;
  if (motion.poses == 0) return out;
  const std::size_t judged = deformers.back();
  const std::string& name = comparison.rows[judged].deformer;
  const std::size_t farthest = farthest_pose(motion, judged), narrowest = motion.of[judged].narrowest_pose;
  Stage stage(study, kMotionSide);
  const auto add = [&](std::size_t number, const char* why) {
    const deform::MotionPose& pose = study.motion.poses[number];
    const deform::Matrix by = standing(study, pose.joint);
    const deform::Pose stands = placed(by, pose.pose());
    PictureRow row;
    row.title = fmt::format("{}: {} {}", title_of(study, pose), name, why);
    stage.draw(
        {stands, truth, comparison, deformers},
        [&](const Stage::Compared& compared) { return stage.close_up(compared, part_of(study.source.mesh, pose, by)); },
        row);
    out.push_back(std::move(row));
  };
  if (farthest != MotionRow::kNowhere) add(farthest, "is farthest from the truth");
  if (narrowest != MotionRow::kNowhere && narrowest != farthest) add(narrowest, "has the narrowest ring beside it");
  return out;
}

}  // namespace marrow::tools
