#include "cook/learn/trainees.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr std::uint32_t kMostFolds = 8;
constexpr std::uint32_t kFoldsOfNoClip = 5;

// Which fold moments belong to.
class Folds {
 public:
  // By ascending clip.
  void see(std::uint32_t clip) {
    if (clips_.empty() || clips_.back() != clip) clips_.push_back(clip);
  }
  std::uint32_t count() const {
    if (clips_.empty()) return kFoldsOfNoClip;
    return many() ? std::min(static_cast<std::uint32_t>(clips_.size()), kMostFolds)
                  : 4 * static_cast<std::uint32_t>(clips_.size());
  }
  std::uint32_t of(std::uint32_t clip, double share_of_clip) const {
    const auto ordinal = static_cast<std::uint32_t>(std::ranges::find(clips_, clip) - clips_.begin());
    return many() ? ordinal % kMostFolds : ordinal * 4 + static_cast<std::uint32_t>(std::min(3.0, 4 * share_of_clip));
  }

 private:
  bool many() const { return clips_.size() > 2; }

  std::vector<std::uint32_t> clips_;
};

deform::TrainingPose rest(const DeformSource& source) {
  return {deform::Pose(source.joints.size(), deform::Matrix(1.0)), 0, false};
}

}  // namespace

Trainees trainees(const DeformSource& source, const BuiltScene& built, const std::vector<SampledPose>& shipped,
                  bool wide) {
  const BuiltSkeleton& skeleton = built.skeletons[source.skeleton];
  Folds folds;
  for (const SampledPose& pose : shipped) folds.see(pose.clip);
  Trainees out;
  for (const SampledPose& pose : shipped) {
    const double duration_s = std::max(1e-6, static_cast<double>(built.clips[pose.clip].duration_s));
    out.poses.push_back({deform_pose(source, skeleton, pose.local),
                         folds.of(pose.clip, static_cast<double>(pose.time_s) / duration_s), true});
  }
  std::uint32_t number = 0;
  for (const SampledPose& pose : resampled_poses(skeleton, shipped, kMadeUp))
    out.poses.push_back({deform_pose(source, skeleton, pose.local), number++ % folds.count(), shipped.empty()});
  for (const SampledPose& pose : turned_poses(skeleton, wide ? kWide : 0, kWide_rad))
    out.poses.push_back({deform_pose(source, skeleton, pose.local), number++ % folds.count(), false});
  out.made_up = number;
  out.poses.push_back(rest(source));
  return out;
}

Trainees trainees(const DeformSource& source, const std::vector<ShownPose>& shown) {
  Folds folds;
  for (const ShownPose& pose : shown) folds.see(pose.clip);
  Trainees out;
  for (const ShownPose& pose : shown) out.poses.push_back({pose.pose, folds.of(pose.clip, pose.share), true});
  out.poses.push_back(rest(source));
  return out;
}

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
