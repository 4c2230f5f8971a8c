#include "cook/skin/sampled_poses.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "common/check_status.h"
#include "common/elementary.h"
#include "cook/scene/views.h"
#include "deform/rotations.h"
#include "marrow/limits.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

glm::dquat rotation_of(const SoaTransform& t, std::size_t lane) {
  return {static_cast<double>(t.rotation[3][lane]), static_cast<double>(t.rotation[0][lane]),
          static_cast<double>(t.rotation[1][lane]), static_cast<double>(t.rotation[2][lane])};
}

void set_rotation(SoaTransform& t, std::size_t lane, const glm::dquat& q) {
  const double parts[] = {q.x, q.y, q.z, q.w};
  for (int c = 0; c < 4; ++c) t.rotation[c][lane] = static_cast<float>(parts[c]);
}

// One joint of four, `share` of the way from one to the other.
void mix_joint(const SoaTransform& from, const SoaTransform& to, double share, std::size_t lane, SoaTransform& out) {
  const auto s = static_cast<float>(share);
  for (int c = 0; c < 3; ++c) {
    out.translation[c][lane] = from.translation[c][lane] + s * (to.translation[c][lane] - from.translation[c][lane]);
    out.scale[c][lane] = from.scale[c][lane] + s * (to.scale[c][lane] - from.scale[c][lane]);
  }
  set_rotation(out, lane, deform::slerp(rotation_of(from, lane), rotation_of(to, lane), share));
}

// In [0, 1); the standard's distributions differ between libraries.
double fraction(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.0;
}

void turn_joint(SoaTransform& t, std::size_t lane, double most_rad, std::mt19937& random) {
  const double z = 2 * fraction(random) - 1, around = 6.283185307179586 * fraction(random), r = std::sqrt(1 - z * z);
  const double half = most_rad * fraction(random) / 2, s = tools::sine(half);
  const glm::dquat turn(tools::cosine(half), s * r * tools::cosine(around), s * r * tools::sine(around), s * z);
  set_rotation(t, lane, rotation_of(t, lane) * turn);
}

}  // namespace

std::vector<SampledPose> clip_poses(const BuiltScene& scene, std::uint32_t skeleton, double rate_hz, std::size_t most) {
  const Skeleton of = view(scene.skeletons[skeleton]);
  std::vector<std::uint32_t> clips;
  double wanted = 0;
  const auto moments = [&](const BuiltClip& clip, double rate) {
    return std::max(2.0, std::ceil(static_cast<double>(clip.duration_s) * rate) + 1);
  };
  for (std::uint32_t i = 0; i < scene.clips.size(); ++i) {
    const BuiltClip& clip = scene.clips[i];
    if (clip.skeleton != skeleton || (clip.tracks.empty() && clip.coded.header.frame_count == 0)) continue;
    clips.push_back(i);
    wanted += moments(clip, rate_hz);
  }
  const double rate = rate_hz * std::min(1.0, static_cast<double>(most) / std::max(wanted, 1.0));
  std::vector<SampledPose> out;
  for (const std::uint32_t i : clips) {
    const Clip clip = view(scene.clips[i], of);
    const auto count = static_cast<std::size_t>(moments(scene.clips[i], rate));
    for (std::size_t k = 0; k < count; ++k) {
      SampledPose pose{std::vector<SoaTransform>(of.soa_size()), i,
                       static_cast<float>(static_cast<double>(clip.duration_s) * static_cast<double>(k) /
                                          static_cast<double>(count - 1))};
      tools::check(sample(of, clip, pose.time_s, pose.local));
      out.push_back(std::move(pose));
    }
  }
  return out;
}

std::vector<SampledPose> resampled_poses(const BuiltSkeleton& skeleton, const std::vector<SampledPose>& poses,
                                         std::size_t count) {
  constexpr double kTurn_rad = 0.7853981633974483;  // 45°
  if (poses.empty()) return turned_poses(skeleton, count, kTurn_rad);
  std::mt19937 random(1);
  std::vector<SampledPose> out(count, {skeleton.rest});
  for (SampledPose& pose : out) {
    for (std::size_t j = 0; j < skeleton.parents.size(); ++j) {
      const SampledPose& from = poses[random() % poses.size()];
      const SampledPose& to = poses[random() % poses.size()];
      mix_joint(from.local[j / 4], to.local[j / 4], fraction(random), j % 4, pose.local[j / 4]);
    }
  }
  return out;
}

std::vector<SampledPose> turned_poses(const BuiltSkeleton& skeleton, std::size_t count, double most_rad) {
  std::mt19937 random(1);
  std::vector<SampledPose> out(count, {skeleton.rest});
  for (SampledPose& pose : out) {
    for (std::size_t j = 0; j < skeleton.parents.size(); ++j) turn_joint(pose.local[j / 4], j % 4, most_rad, random);
    tools::check(limit_pose(skeleton.limits, pose.local));
  }
  return out;
}

std::vector<Affine> model_pose(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local) {
  std::vector<Affine> out(skeleton.parents.size());
  tools::check(local_to_model(view(skeleton), local, out));
  return out;
}

}  // namespace marrow::cook
