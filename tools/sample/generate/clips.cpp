// Samples the choreography into keys: linear and cubic tracks for the body, steps for the blinking eyelids.
#include "clips.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "choreography.h"
#include "face.h"

namespace marrow::sample {
namespace {

using PoseAt = Pose (*)(float phase);

struct Plan {
  const char* name;
  float duration;
  int linear_keys;  // intervals between keys over the loop
  int cubic_keys;
  PoseAt pose;
  std::function<Interpolation(int target)> interpolation;
  std::vector<std::pair<int, float>> blink;  // when (of linear_keys), and how far the lids are shut from then on
};

std::size_t at(int joint) {
  return static_cast<std::size_t>(joint);
}

glm::quat parent_turn(int joint) {
  const int parent = skeleton()[at(joint)].parent;
  return parent < 0 ? glm::quat(1, 0, 0, 0) : skeleton()[at(parent)].turn;
}

// A node's local value for a pose; three numbers, or four (x, y, z, w) for a rotation.
glm::vec4 local_value(const Pose& pose, int target, Path path) {
  if (target >= kFaceTarget) {
    const int side = target - kFaceTarget - kEyeL;
    const glm::quat q = glm::normalize(glm::inverse(skeleton()[kHead].turn) * pose.gaze * eye_turn(side));
    return {q.x, q.y, q.z, q.w};
  }
  if (path == Path::scale) return {pose.scale[at(target)], 0};
  if (path == Path::translation) return {skeleton()[at(target)].head + pose.hips, 0};
  const glm::quat q =
      glm::normalize(glm::inverse(parent_turn(target)) * pose.turn[at(target)] * skeleton()[at(target)].turn);
  return {q.x, q.y, q.z, q.w};
}

bool is_still(const Plan& plan, int target, Path path) {
  const glm::vec4 rest = local_value(Pose(), target, path);
  for (int i = 0; i < plan.linear_keys; ++i) {
    const Pose pose = plan.pose(static_cast<float>(i) / static_cast<float>(plan.linear_keys));
    const glm::vec4 value = local_value(pose, target, path);
    if (std::min(glm::distance(value, rest), glm::distance(value, -rest)) > 1e-4f) return false;
  }
  return true;
}

void append(std::vector<float>& values, glm::vec4 value, Path path) {
  for (int i = 0; i < (path == Path::rotation ? 4 : 3); ++i) values.push_back(value[i]);
}

Track make_track(const Plan& plan, int target, Path path) {
  Track track{target, path, plan.interpolation(target), {}, {}};
  const bool cubic = track.interpolation == Interpolation::cubic;
  const int keys = cubic ? plan.cubic_keys : plan.linear_keys;
  glm::vec4 before(0);
  // The same hemisphere as the key before, so that interpolation takes the short way.
  const auto value_at = [&](float phase) {
    const glm::vec4 value = local_value(plan.pose(phase), target, path);
    return path == Path::rotation && glm::dot(value, before) < 0 ? -value : value;
  };
  for (int i = 0; i <= keys; ++i) {
    const float phase = static_cast<float>(i % keys) / static_cast<float>(keys);  // the last key repeats the first
    track.times.push_back(plan.duration * static_cast<float>(i) / static_cast<float>(keys));
    const glm::vec4 value = value_at(phase);
    before = value;
    if (!cubic) {
      append(track.values, value, path);
      continue;
    }
    constexpr float kStep = 2e-3f;
    const glm::vec4 tangent = (value_at(phase + kStep) - value_at(phase - kStep)) / (2 * kStep * plan.duration);
    append(track.values, tangent, path);
    append(track.values, value, path);
    append(track.values, tangent, path);
  }
  return track;
}

Track make_blink(const Plan& plan, int side) {
  Track track{kFaceTarget + kLidL + side, Path::rotation, Interpolation::step, {}, {}};
  const glm::quat eye = glm::inverse(skeleton()[kHead].turn) * eye_turn(side);
  const auto add = [&](int when, float shut) {
    track.times.push_back(plan.duration * static_cast<float>(when) / static_cast<float>(plan.linear_keys));
    const glm::quat q = glm::normalize(eye * lid_turn(side, shut));
    append(track.values, {q.x, q.y, q.z, q.w}, Path::rotation);
  };
  add(0, kLidAtRest);
  for (const auto& [when, shut] : plan.blink) add(when, shut);
  add(plan.linear_keys, kLidAtRest);
  return track;
}

Clip make_clip(const Plan& plan) {
  Clip clip{plan.name, {}};
  clip.tracks.push_back(make_track(plan, kPelvis, Path::translation));
  for (int joint = 0; joint < kJointCount; ++joint) {
    for (const Path path : {Path::rotation, Path::scale}) {
      if (!is_still(plan, joint, path)) clip.tracks.push_back(make_track(plan, joint, path));
    }
  }
  for (int side = 0; side < 2; ++side) {
    const int eye = kFaceTarget + kEyeL + side;
    if (!is_still(plan, eye, Path::rotation)) clip.tracks.push_back(make_track(plan, eye, Path::rotation));
    clip.tracks.push_back(make_blink(plan, side));
  }
  return clip;
}

}  // namespace

std::vector<Clip> make_clips() {
  const auto linear = [](int) { return Interpolation::linear; };
  const auto cubic = [](int) { return Interpolation::cubic; };
  // The snappy body is sampled densely; tail, gills and eyes drift, which few cubic keys say as well.
  const auto mixed = [](int target) {
    const bool drifts = (target >= kTail1 && target <= kTail8) || target >= kFaceTarget;
    return drifts ? Interpolation::cubic : Interpolation::linear;
  };
  const std::vector<std::pair<int, float>> none;
  const Plan plans[] = {
      {"idle", 3.0f, 72, 16, idle_pose, cubic, {{30, .6f}, {31, 1}, {34, .55f}, {36, kLidAtRest}}},
      {"walk", 1.2f, 36, 12, walk_pose, linear, {{20, .6f}, {21, 1}, {24, .5f}, {26, kLidAtRest}}},
      {"twist", 2.8f, 70, 20, twist_pose, cubic, {{16, .6f}, {17, 1}, {20, .5f}, {22, kLidAtRest}}},
      {"reach",
       3.0f,
       72,
       30,
       reach_pose,
       mixed,
       {{3, .55f}, {4, 1}, {8, .5f}, {10, kLidAtRest}, {26, 0}, {44, .6f}, {45, 1}, {48, .5f}, {50, kLidAtRest}}},
  };
  std::vector<Clip> clips;
  for (const Plan& plan : plans) clips.push_back(make_clip(plan));
  return clips;
}

}  // namespace marrow::sample
