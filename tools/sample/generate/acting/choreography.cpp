// The acting: walking, twisting, reaching for something overhead, and idling about.
#include "acting/choreography.h"

#include <cmath>

#include "acting/gestures.h"

namespace marrow::sample {

Pose walk_pose(float phase) {
  Pose pose;
  // The left heel strikes at 0, the right one at .5; each leg carries the weight halfway through its stance.
  const float forward = std::cos(kTau * phase), carry = std::cos(kTau * (phase - .30f));
  const float bob = std::cos(2 * kTau * (phase - .06f));
  pose.hips = {.022f * carry, -.024f - .012f * bob, .004f * wave(2 * phase)};
  bend(pose, kPelvis, 2, -9 * forward, 5 * carry);
  bend_spine(pose, 2, 15 * forward, -8 * carry);
  bend_head(pose, -3 + 2.5f * std::cos(2 * kTau * (phase - .16f)), -6 * forward, 5 * std::cos(kTau * (phase - .38f)));
  for (int side = 0; side < 2; ++side) {
    const float own = side == 0 ? phase : phase + .5f;
    plant_foot(pose, side, walking_foot(own), {side_sign(side) * .28f, 0, 1});
    const float swing = -std::cos(kTau * (own - .03f));  // arms go against the legs
    const glm::vec3 along = turned(-27 * swing - 4, 0, 0) * glm::vec3(.60f, -.80f, 0);
    aim_arm(pose, side, along, {-.12f, .1f, 1}, 40 + 17 * -std::cos(kTau * (own - .10f)));
    relax_hand(pose, side, 22 + 10 * wave(own, .2f));
    bend(pose, on_side(kClavicle, side), 0, side_sign(side) * -5 * swing, side_sign(side) * 2 * wave(2 * own));
  }
  bend(pose, kTail1, 6 + 3 * bob, 6 * forward, -3 * carry);
  sway_tail(pose, phase + .25f, 9, .075f);
  for (int i = 2; i < kTailCount; ++i)
    bend(pose, kTail1 + i, 2.5f * std::cos(2 * kTau * (phase - .05f * static_cast<float>(i))));
  flutter_gills(pose, 2 * phase, 8);
  pose.scale[kBelly] = glm::vec3(1 + .02f * std::cos(2 * kTau * (phase - .12f)));
  bend(pose, kBelly, 4 * std::cos(2 * kTau * (phase - .14f)), 3 * std::cos(kTau * (phase - .1f)), 0);
  return pose;
}

Pose twist_pose(float phase) {
  Pose pose;
  const float s = wave(phase), held = s * (1.5f - .5f * s * s);  // dwells at both ends
  pose.hips = {.030f * wave(phase, .05f), -.030f - .014f * std::cos(2 * kTau * phase), 0};
  bend(pose, kPelvis, 0, 10 * wave(phase, -.03f), -4 * wave(phase, .05f));
  bend_spine(pose, -3, 42 * wave(phase, .02f), 6 * wave(phase, .05f));
  bend_head(pose, -4, -64 * wave(phase, .06f), 9 * wave(phase, .1f));
  for (int side = 0; side < 2; ++side) {
    const float sign = side_sign(side);
    plant_foot(pose, side, {}, {sign * .45f, 0, 1});
    aim_arm(pose, side, {.86f, -.34f + .06f * sign * s, .26f}, {.35f, 1, .35f}, 52 + 8 * std::cos(2 * kTau * phase));
    // The whole pronation sits between elbow and wrist: on the right half of it on the helper joint.
    const float pronation = -sign * 168 * held;
    if (side == 0) {
      twist(pose, kHand, pronation);
    } else {
      twist(pose, kForearmTwistR, pronation * .5f);
      twist(pose, on_side(kHand, 1), pronation * .5f);
    }
    bend(pose, on_side(kClavicle, side), 0, 0, sign * (4 + 3 * wave(phase, .1f)));
    bend(pose, on_side(kFingers, side), 0, 0, sign * 10 * wave(phase, .12f));
  }
  bend(pose, kTail1, 5, -8 * wave(phase), 0);
  sway_tail(pose, phase + .5f, 15, .045f);
  flutter_gills(pose, phase, 10);
  bend(pose, kBelly, 0, 7 * wave(phase, .1f), 0);
  pose.gaze = turned(0, -12 * wave(phase, .02f), 0);
  return pose;
}

Pose reach_pose(float phase) {
  Pose pose;
  // Gathers itself in a deep squat, springs up on its toes with the left hand high, brings the catch to its face.
  const float squat = curve({{0, 0}, {.20f, 1}, {.26f, 1}, {.42f, 0}, {.60f, 0}, {.74f, .30f}, {.88f, .12f}}, phase);
  const float high = curve({{0, 0}, {.25f, 0}, {.43f, 1}, {.57f, 1}, {.72f, 0}}, phase);
  const float hold = curve({{0, 0}, {.58f, 0}, {.75f, 1}, {.86f, 1}}, phase);
  const float curl = curve({{0, .12f}, {.22f, 1}, {.44f, .0f}, {.60f, .25f}, {.78f, .9f}}, phase);
  pose.hips = {.020f * high - .01f * squat, -.012f - .180f * squat + .050f * high, -.045f * squat + .034f * high};
  bend(pose, kPelvis, 15 * squat - 4 * high, 0, 5 * high);
  bend_spine(pose, 10 * squat - 14 * high + 6 * hold, 12 * high - 5 * squat, -16 * high);
  bend_head(pose, -20 * squat - 26 * high + 15 * hold, 12 * high + 10 * hold, 6 * high + 7 * hold);
  for (int side = 0; side < 2; ++side) {
    Stand stand;
    stand.pitch = -30 * high;
    plant_foot(pose, side, stand, {side_sign(side) * (.35f + .75f * squat), 0, 1});
  }
  const glm::vec3 kRest(.60f, -.80f, .06f), kTucked(.78f, -.62f, -.10f);
  const glm::vec3 left = curve({{0, kRest},
                                {.22f, kTucked},
                                {.44f, {.70f, .70f, .26f}},
                                {.57f, {.66f, .73f, .30f}},
                                {.74f, {.74f, -.56f, .36f}},
                                {.86f, {.74f, -.56f, .36f}}},
                               phase);
  const glm::vec3 left_to = curve({{0, {-.1f, .1f, 1}},
                                   {.22f, {-.1f, .55f, 1}},
                                   {.50f, {-.2f, .3f, 1}},
                                   {.72f, {-.42f, .75f, .80f}},
                                   {.86f, {-.42f, .75f, .80f}}},
                                  phase);
  aim_arm(pose, 0, left, left_to,
          curve({{0, 36}, {.22f, 118}, {.43f, 12}, {.57f, 10}, {.75f, 118}, {.86f, 114}}, phase));
  const glm::vec3 right = curve({{0, kRest},
                                 {.22f, kTucked},
                                 {.45f, {.80f, -.55f, -.35f}},
                                 {.58f, {.80f, -.55f, -.35f}},
                                 {.78f, {.62f, -.74f, .25f}}},
                                phase);
  aim_arm(pose, 1, right, {-.1f, .35f, 1}, curve({{0, 36}, {.22f, 118}, {.45f, 30}, {.58f, 34}, {.78f, 72}}, phase));
  bend(pose, kClavicle, 0, 0, 18 * high);
  relax_hand(pose, 0, curve({{0, 20}, {.22f, 50}, {.42f, -16}, {.54f, -16}, {.62f, 62}, {.86f, 58}}, phase));
  relax_hand(pose, 1, 20 + 25 * squat);
  for (int i = 0; i < kTailCount; ++i) {
    const auto along = static_cast<float>(i);
    const float late = curve({{0, .12f}, {.25f, 1}, {.47f, .0f}, {.63f, .25f}, {.81f, .9f}}, phase - .012f * along);
    bend(pose, kTail1 + i, i < 3 ? 9 * squat - 5 * high : 31 * late, 5 * wave(phase, .06f * along), 6 * curl);
  }
  flutter_gills(pose, 2 * phase, 9);
  bend(pose, kBelly, 10 * curve({{0, 0}, {.30f, .8f}, {.46f, -1}, {.56f, .4f}, {.66f, 0}}, phase), 0, 0);
  pose.gaze = turned(-12 * high + 8 * hold, 6 * high - 8 * hold, 0);
  return pose;
}

Pose idle_pose(float phase) {
  Pose pose;
  const float breath = wave(phase);
  pose.hips = {.010f * wave(phase, .1f), -.014f + .005f * wave(phase, .05f), 0};
  bend(pose, kPelvis, 0, 0, -1.5f * wave(phase, .1f));
  bend_spine(pose, -2.5f * breath, 0, 2 * wave(phase, .12f));
  bend_head(pose, 3 * wave(phase, .15f), 7 * wave(phase, .3f), 6 * wave(phase, .2f));
  for (int side = 0; side < 2; ++side) {
    const float sign = side_sign(side);
    plant_foot(pose, side, {}, {sign * .3f, 0, 1});
    aim_arm(pose, side, glm::vec3(.62f, -.78f, .05f), {-.1f, .1f, 1}, 38 + 5 * wave(phase, .15f));
    relax_hand(pose, side, 20 + 7 * wave(phase, .2f + .1f * sign));
    bend(pose, on_side(kClavicle, side), 0, 0, sign * 3 * wave(phase, .05f));
    for (const Joint gill : {kGillTop, kGillMid, kGillLow}) {
      pose.scale[static_cast<std::size_t>(on_side(gill, side))] = glm::vec3(1 + .05f * wave(2 * phase, .1f));
    }
  }
  pose.scale[kBelly] = glm::vec3(1 + .05f * breath, 1 + .02f * breath, 1 + .07f * breath);
  bend(pose, kTail1, 3, 0, 0);
  sway_tail(pose, phase, 7, .09f);
  for (int i = 4; i < kTailCount; ++i) bend(pose, kTail1 + i, 9 + 6 * wave(phase, .06f * static_cast<float>(i)));
  flutter_gills(pose, phase, 7);
  pose.gaze = turned(0, 9 * wave(phase, .27f), 0);
  return pose;
}

}  // namespace marrow::sample
