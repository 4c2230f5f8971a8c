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
// they go together as they may. Without poses, joints are turned from rest by up to 45° about any axis. The same on
// every run.
std::vector<SampledPose> resampled_poses(const BuiltSkeleton& skeleton, const std::vector<SampledPose>& poses,
                                         std::size_t count);

// scene_from_joint.
std::vector<Affine> model_pose(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local);

}  // namespace marrow::cook
