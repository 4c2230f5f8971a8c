// Samples the choreography into keys: linear and cubic tracks for the body, steps for the blinking eyelids.
#include "clips.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "acting/choreography.h"
#include "acting/game_moves.h"
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
  float way = 0;      // metres that a loop goes ahead, evenly; what is played once has them in its poses
  bool once = false;  // phases are 0 … 1, and the end is not the beginning
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
  const glm::quat heading = turned(0, pose.heading, 0);
  if (path == Path::translation) {
    const glm::vec3 hips = skeleton()[at(target)].head + pose.hips;
    return {pose.heading == 0 ? hips + pose.way : heading * hips + pose.way, 0};
  }
  const glm::quat in_place =
      glm::normalize(glm::inverse(parent_turn(target)) * pose.turn[at(target)] * skeleton()[at(target)].turn);
  const glm::quat q = target == kPelvis && pose.heading != 0 ? glm::normalize(heading * in_place) : in_place;
  return {q.x, q.y, q.z, q.w};
}

bool is_still(const Plan& plan, int target, Path path) {
  const glm::vec4 rest = local_value(Pose(), target, path);
  for (int i = 0; i < plan.linear_keys + (plan.once ? 1 : 0); ++i) {
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
    Pose pose = plan.pose(phase);
    pose.way.z += plan.way * phase;
    const glm::vec4 value = local_value(pose, target, path);
    return path == Path::rotation && glm::dot(value, before) < 0 ? -value : value;
  };
  for (int i = 0; i <= keys; ++i) {
    // The last key of a loop repeats the first.
    const bool again = i == keys && !plan.once;
    const float phase = again ? 0.0f : static_cast<float>(i) / static_cast<float>(keys);
    track.times.push_back(plan.duration * static_cast<float>(i) / static_cast<float>(keys));
    glm::vec4 value = value_at(phase);
    before = value;
    if (again && path == Path::translation) value.z += plan.way;
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
  Clip clip{plan.name, {}, {}};
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

Interpolation linear(int) {
  return Interpolation::linear;
}
Interpolation cubic(int) {
  return Interpolation::cubic;
}

const Plan kIdle{"idle", 3.0f, 72, 16, idle_pose, cubic, {{30, .6f}, {31, 1}, {34, .55f}, {36, kLidAtRest}}};
const Plan kWalk{"walk", 1.2f, 36, 12, walk_pose, linear, {{20, .6f}, {21, 1}, {24, .5f}, {26, kLidAtRest}}};

std::vector<Clip> make_clips(std::span<const Plan> plans) {
  std::vector<Clip> clips;
  for (const Plan& plan : plans) clips.push_back(make_clip(plan));
  return clips;
}

}  // namespace

std::vector<Clip> make_clips() {
  // The snappy body is sampled densely; tail, gills and eyes drift, which few cubic keys say as well.
  const auto mixed = [](int target) {
    const bool drifts = (target >= kTail1 && target <= kTail8) || target >= kFaceTarget;
    return drifts ? Interpolation::cubic : Interpolation::linear;
  };
  const Plan plans[] = {
      kIdle,
      kWalk,
      {"twist", 2.8f, 70, 20, twist_pose, cubic, {{16, .6f}, {17, 1}, {20, .5f}, {22, kLidAtRest}}},
      {"reach",
       3.0f,
       72,
       30,
       reach_pose,
       mixed,
       {{3, .55f}, {4, 1}, {8, .5f}, {10, kLidAtRest}, {26, 0}, {44, .6f}, {45, 1}, {48, .5f}, {50, kLidAtRest}}},
  };
  return make_clips(plans);
}

std::vector<Clip> make_moves() {
  const auto once = [](const char* name, float seconds, int keys, PoseAt pose,
                       std::vector<std::pair<int, float>> blink = {}) {
    return Plan{name, seconds, keys, 0, pose, linear, std::move(blink), 0, true};
  };
  const Plan plans[] = {
      kIdle,
      kWalk,
      {"run", kRunRound_s, 28, 0, run_pose, linear, {}, kRunStride},
      once("start", kStart_s, 28, start_pose),
      once("stop", kStop_s, 46, stop_pose, {{18, .6f}, {19, 1}, {22, .5f}, {24, kLidAtRest}}),
      once("turn_left", kTurn_s, 48, turn_pose, {{5, .6f}, {6, 1}, {11, .5f}, {13, kLidAtRest}}),
      once("jump", kJump_s, 23, jump_pose),
      {"rise", .6f, 12, 0, rise_pose, linear, {}, .6f * kRunSpeed},
      {"fall", .6f, 12, 0, fall_pose, linear, {}, .6f * kRunSpeed},
      once("land", kLand_s, 25, land_pose, {{3, .8f}, {4, 1}, {7, .4f}, {8, kLidAtRest}}),
      once("hit", kHit_s, 50, hit_pose,
           {{1, .9f}, {2, 1}, {15, .6f}, {18, .35f}, {38, .8f}, {40, .4f}, {43, kLidAtRest}}),
  };
  std::vector<Clip> clips = make_clips(plans);
  // Where a leg passes the other, clips that are played once may follow.
  for (Clip& clip : clips)
    if (clip.name == "walk" || clip.name == "run") clip.events = {"passing@25%"};
  return clips;
}

}  // namespace marrow::sample
