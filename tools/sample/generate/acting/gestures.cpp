#include "acting/gestures.h"

#include <cmath>

namespace marrow::sample {

float wave(float phase, float lag) {
  return std::sin(kTau * (phase - lag));
}

void bend_spine(Pose& pose, float x, float y, float z) {
  for (const int joint : {kSpine1, kSpine2, kChest}) bend(pose, joint, x / 3, y / 3, z / 3);
}

void bend_head(Pose& pose, float x, float y, float z) {
  bend(pose, kNeck, x * .4f, y * .4f, z * .4f);
  bend(pose, kHead, x * .6f, y * .6f, z * .6f);
}

void sway_tail(Pose& pose, float phase, float degrees, float lag) {
  for (int i = 0; i < kTailCount; ++i) {
    const auto along = static_cast<float>(i);
    bend(pose, kTail1 + i, 0, degrees * (.6f + .1f * along) * wave(phase, lag * along), 0);
  }
}

void flutter_gills(Pose& pose, float phase, float degrees) {
  for (int side = 0; side < 2; ++side) {
    const float sign = side_sign(side);
    bend(pose, on_side(kGillTop, side), .5f * degrees * wave(phase), sign * degrees * .5f * wave(phase, .15f),
         sign * degrees * wave(phase, .10f));
    bend(pose, on_side(kGillMid, side), 0, sign * degrees * .5f * wave(phase, .22f),
         sign * degrees * wave(phase, .18f));
    bend(pose, on_side(kGillLow, side), 0, sign * degrees * .5f * wave(phase, .30f),
         sign * degrees * wave(phase, .26f));
  }
}

void relax_hand(Pose& pose, int side, float curl) {
  const float sign = side_sign(side);
  const glm::vec3 along = bone_direction(on_side(kHand, side));
  const glm::vec3 axis = glm::normalize(glm::cross(along, glm::vec3(-sign, -.9f, 0)));
  pose.turn[static_cast<std::size_t>(on_side(kHand, side))] *= glm::angleAxis(glm::radians(curl * .5f), axis);
  pose.turn[static_cast<std::size_t>(on_side(kFingers, side))] = glm::angleAxis(glm::radians(curl), axis);
}

float stride(float phase, float stance, float front, float back) {
  if (phase < stance) return glm::mix(front, back, phase / stance);  // carried by the ground
  // The swing leaves and arrives at the speed of the ground, so that the foot never skids.
  const float t = (phase - stance) / (1 - stance), t2 = t * t, t3 = t2 * t;
  const float speed = (back - front) / stance * (1 - stance);
  return (2 * t3 - 3 * t2 + 1) * back + (t3 - 2 * t2 + t) * speed + (3 * t2 - 2 * t3) * front + (t3 - t2) * speed;
}

Stand walking_foot(float phase) {
  constexpr float kStance = .60f, kFront = .125f, kBack = -.145f;
  phase -= std::floor(phase);
  Stand stand;
  stand.shift.z = stride(phase, kStance, kFront, kBack);
  stand.shift.y = curve({{0.0f, 0.0f}, {kStance, 0.0f}, {.80f, .062f}}, phase);
  stand.pitch =
      curve({{0.0f, 14.0f}, {.11f, 0.0f}, {.36f, 0.0f}, {kStance, -40.0f}, {.72f, -28.0f}, {.93f, 17.0f}}, phase);
  return stand;
}

}  // namespace marrow::sample
