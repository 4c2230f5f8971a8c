#include "cook/learn/trainees.h"

#include <algorithm>

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

}  // namespace marrow::cook
