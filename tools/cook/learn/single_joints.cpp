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

std::uint32_t folds_of(const std::vector<deform::TrainingPose>& poses) {
  std::uint32_t out = 1;
  for (const deform::TrainingPose& p : poses) out = std::max(out, p.fold + 1);
  return out;
}

// How large shipped poses are beside the bind pose: characters in centimetres are often scaled to metres by their root.
double size_of(const std::vector<deform::TrainingPose>& poses) {
  double sum = 0, count = 0;
  for (const deform::TrainingPose& p : poses) {
    if (!p.shipped) continue;
    for (const deform::Matrix& m : p.pose)
      for (int c = 0; c < 3; ++c) sum += glm::dot(m[c], m[c]);
    count += 3 * static_cast<double>(p.pose.size());
  }
  return count > 0 && std::isfinite(sum) && sum > 0 ? std::sqrt(sum / count) : 1;
}

}  // namespace

std::vector<deform::TrainingPose> single_joints(const std::vector<deform::MotionPose>& motion, std::size_t most,
                                                const std::vector<deform::TrainingPose>& beside) {
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
  const std::uint32_t folds = folds_of(beside);
  const double size = size_of(beside);
  std::vector<deform::TrainingPose> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * all / count;
    deform::MotionPose turned = farthest[at / std::size(kShares)];
    turned.angle_rad *= kShares[at % std::size(kShares)];
    deform::Pose pose = turned.pose();
    for (deform::Matrix& m : pose)
      for (int c = 0; c < 4; ++c) m[c] *= size;
    out.push_back({std::move(pose), static_cast<std::uint32_t>(i) % folds, false});
  }
  return out;
}

}  // namespace marrow::cook
