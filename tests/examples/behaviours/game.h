// What a game does around the graphs that stand beside this file; docs/cooking/behaviours.md shows it.
#pragma once

#include <marrow/owned.h>

#include <algorithm>
#include <cmath>

namespace game {

using namespace marrow;

// Degrees from where the character looks to a point of the world; to the left above 0.
inline float degrees_to(const Affine& world_from_model, float x, float z) {
  const auto& row = world_from_model.rows;
  const float to_x = x - row[0][3], to_z = z - row[2][3];
  return 57.29578f * std::atan2(to_x * row[2][2] - to_z * row[0][2], to_x * row[0][2] + to_z * row[2][2]);
}

// How far it is below the highest point of its flight.
inline float metres_fallen(float& highest_m, float height_m, bool was_grounded) {
  highest_m = was_grounded ? height_m : std::max(highest_m, height_m);
  return highest_m - height_m;
}

// Whether a foot comes down. One that stands all through a clip is met as the clip begins, and makes no sound.
inline bool is_step(const AnimatorEvent& event) {
  return event.until_s - event.time_s < event.animation->duration_s;
}

// Which foot came down last.
inline void hear_feet(const AnimatorStep& step, Animator& hero, std::uint32_t left) {
  for (const AnimatorEvent& event : step.events) {
    if (!is_step(event)) continue;
    if (event.id == event_id("left_foot")) must(set_flag(hero, left, true));
    if (event.id == event_id("right_foot")) must(set_flag(hero, left, false));
  }
}

// The rider goes where the saddle goes, whatever its own root would do.
inline Affine seat(const Affine& world_from_mount, const Pose& mount, std::uint32_t saddle) {
  Affine world_from_rider = {};
  const Affine& model_from_saddle = mount.model_from_joint[saddle];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      for (int k = 0; k < 3; ++k)
        world_from_rider.rows[r][c] += world_from_mount.rows[r][k] * model_from_saddle.rows[k][c];
      if (c == 3) world_from_rider.rows[r][c] += world_from_mount.rows[r][3];
    }
  return world_from_rider;
}

struct Door {
  bool is_open = false;
  float hand_s = 0, weight = 0;  // how long the hand stays, how much of the way it has gone
};

inline void hear_door(const AnimatorStep& step, float dt_s, Door& door) {
  door.hand_s -= dt_s;
  for (const AnimatorEvent& event : step.events) {
    if (event.id == event_id("open")) door.is_open = true;  // it swings from now on
    if (event.id == event_id("reach")) door.hand_s = event.until_s - event.time_s;
  }
  const float wanted = door.hand_s > 0 ? 1.0f : 0.0f;
  door.weight += std::clamp(wanted - door.weight, -8 * dt_s, 8 * dt_s);  // there in 1/8 s
}

inline void reach_handle(const Pose& pose, const TwoBoneLimb& arm, const Door& door, const float (&handle)[3]) {
  TwoBone reach;
  std::copy(handle, handle + 3, reach.target);
  reach.weight = door.weight;
  must(solve_two_bone(pose, arm, reach));
}

// physics: local poses of the bodies, one transform for four joints as everywhere; used while the graph says so.
inline void pose_limp(Character& hero, Animator& animator, Span<const SoaTransform> physics) {
  const GivenPose given{physics};  // of the graph's one given node, and the character's one skeleton
  must(pose_character(hero, animator, {&given, 1}));
}

}  // namespace game
