// Poses of a skeleton to learn from: its clips' own, and some that they could have had.
#pragma once

#include <cstdint>
#include <vector>

#include "cook/scene/built.h"

namespace marrow::cook {

struct SampledPose {
  std::vector<SoaTransform> local;
  std::uint32_t clip = 0;  // which of the built scene
  float time_s = 0;
};

// Moments of all clips of a skeleton, `rate_hz` a second and both ends, thinned evenly to at most `most`, but two a
// clip.
std::vector<SampledPose> clip_poses(const BuiltScene& scene, std::uint32_t skeleton, double rate_hz, std::size_t most);

// `count` poses in each of which every joint is somewhere between two moments of `poses`, each joint between others:
// they go together as they may. Without poses they are turned_poses() of 45°. The same on every run.
std::vector<SampledPose> resampled_poses(const BuiltSkeleton& skeleton, const std::vector<SampledPose>& poses,
                                         std::size_t count);

// `count` poses in each of which every joint is turned from rest by up to `most_rad` about any axis, and then back into
// its limit if it has one. The same on every run.
std::vector<SampledPose> turned_poses(const BuiltSkeleton& skeleton, std::size_t count, double most_rad);

// model_from_joint.
std::vector<Affine> model_pose(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local);

}  // namespace marrow::cook
