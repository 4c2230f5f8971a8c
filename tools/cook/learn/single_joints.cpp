#include "cook/learn/single_joints.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kShares[] = {0.4, 0.85};

bool turn_alike(const deform::MotionPose& a, const deform::MotionPose& b) {
  return a.joint == b.joint && a.kind == b.kind && (a.angle_rad > 0) == (b.angle_rad > 0);
}

// In the root mean square over joints and axes.
double size_of(const deform::Pose& pose) {
  double sum = 0;
  for (const deform::Matrix& m : pose)
    for (int c = 0; c < 3; ++c) sum += glm::dot(m[c], m[c]);
  return std::sqrt(sum / (3 * static_cast<double>(pose.size())));
}

}  // namespace

std::vector<deform::TrainingPose> single_joints(const std::vector<deform::MotionPose>& motion, std::size_t most,
                                                std::uint32_t folds) {
  // Poses of one joint, kind and side stand one after the other.
  std::vector<deform::MotionPose> farthest;
  for (const deform::MotionPose& pose : motion) {
    if (farthest.empty() || !turn_alike(farthest.back(), pose)) {
      farthest.push_back(pose);
    } else if (std::abs(pose.angle_rad) > std::abs(farthest.back().angle_rad)) {
      farthest.back() = pose;
    }
  }
  const std::size_t all = farthest.size() * std::size(kShares), count = std::min(all, most);
  std::vector<deform::TrainingPose> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * all / count;
    deform::MotionPose turned = farthest[at / std::size(kShares)];
    turned.angle_rad *= kShares[at % std::size(kShares)];
    out.push_back({turned.pose(), static_cast<std::uint32_t>(i) % folds, false});
  }
  return out;
}

void bring_to_bind_size(std::vector<deform::TrainingPose>& poses) {
  constexpr double kSmall = 0.5, kLarge = 2;
  for (deform::TrainingPose& p : poses) {
    const double size = size_of(p.pose);
    if (!(size > 0) || !std::isfinite(size) || (size >= kSmall && size <= kLarge)) continue;
    for (deform::Matrix& m : p.pose)
      for (int c = 0; c < 4; ++c) m[c] /= size;
  }
}

}  // namespace marrow::cook
