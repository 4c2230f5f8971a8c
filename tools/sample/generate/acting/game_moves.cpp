#include "acting/game_moves.h"

#include <cmath>

#include "acting/choreography.h"
#include "acting/gestures.h"

namespace marrow::sample {
namespace {

constexpr float kWalkRound_s = 1.2f, kWalkSpeed = .375f;
constexpr float kRunStance = .34f, kRunFront = .125f;

// Rises from 0 to 1 between two moments.
float ease(float from, float to, float at) {
  return passage({{from, 0.0f}, {to, 1.0f}}, at);
}

Stand mix(const Stand& a, const Stand& b, float share) {
  return {glm::mix(a.shift, b.shift, share), glm::mix(a.pitch, b.pitch, share), glm::mix(a.yaw, b.yaw, share)};
}

Stand running_foot(float phase) {
  phase -= std::floor(phase);
  Stand stand;
  stand.shift.z = stride(phase, kRunStance, kRunFront, kRunFront - kRunStride * kRunStance);
  stand.shift.y = curve({{0.0f, 0.0f}, {kRunStance, 0.0f}, {.58f, .135f}, {.80f, .075f}}, phase);
  stand.pitch = curve(
      {{0.0f, 9.0f}, {.07f, 0.0f}, {.17f, 0.0f}, {kRunStance, -52.0f}, {.50f, -62.0f}, {.74f, -12.0f}, {.92f, 14.0f}},
      phase);
  return stand;
}

// What a leap adds to the run: each 0 in the run itself.
struct Leap {
  float crouch = 0;   // metres that the hips are lower
  float gather = 0;   // degrees that it bends forward
  float wings = 0;    // 0 … 1: arms out and up
  float swing = 1;    // of the arms, against the legs
  float tail_up = 0;  // degrees
  float bob = 1;      // of the hips
};

void run_arms(Pose& pose, float phase, const Leap& leap) {
  for (int side = 0; side < 2; ++side) {
    const float own = side == 0 ? phase : phase + .5f;
    const float swing = -leap.swing * std::cos(kTau * (own - .02f));
    const glm::vec3 pumping = turned(-46 * swing - 6, 0, 0) * glm::vec3(.56f, -.82f, 0);
    const glm::vec3 spread(.95f, -.30f + .20f * leap.wings, -.20f);
    aim_arm(pose, side, glm::mix(pumping, spread, leap.wings),
            glm::mix(glm::vec3(-.08f, .32f, 1), glm::vec3(.45f, 1, .05f), leap.wings),
            glm::mix(82 - 20 * std::cos(kTau * (own - .10f)), 24.0f, leap.wings));
    relax_hand(pose, side, glm::mix(46 + 8 * wave(own, .2f), 4.0f, leap.wings));
    bend(pose, on_side(kClavicle, side), 0, side_sign(side) * -9 * swing,
         side_sign(side) * (2 * wave(2 * own) + 9 * leap.wings));
  }
}

// All but the legs.
Pose run_body(float phase, const Leap& leap) {
  Pose pose;
  const float forward = std::cos(kTau * phase), carry = std::cos(kTau * (phase - .17f));
  // Lowest in the middle of a stance, highest in the middle of a flight.
  const float low = leap.bob * std::cos(2 * kTau * (phase - .17f));
  const float late = leap.bob * std::cos(2 * kTau * (phase - .23f));
  pose.hips = {.011f * carry, -.036f - .026f * low - leap.crouch, -.008f - .25f * leap.crouch};
  bend(pose, kPelvis, 12 + 3 * low + .45f * leap.gather, -13 * forward, 5 * carry);
  bend_spine(pose, 14 + 4 * late + leap.gather, 27 * forward, -9 * carry);
  bend_head(pose, -21 - 4 * std::cos(2 * kTau * (phase - .29f)) - .9f * leap.gather,
            -13 * std::cos(kTau * (phase - .02f)), 5 * std::cos(kTau * (phase - .26f)));
  run_arms(pose, phase, leap);
  bend(pose, kTail1, 15 + 5 * late + leap.tail_up, 9 * forward, -4 * carry);
  sway_tail(pose, phase + .22f, 11, .085f);
  for (int i = 2; i < kTailCount; ++i) {
    const float lag = .055f * static_cast<float>(i);
    bend(pose, kTail1 + i, 4 * std::cos(2 * kTau * (phase - .20f - lag)) + .25f * leap.tail_up - 2);
  }
  flutter_gills(pose, 2 * phase, 13);
  for (int side = 0; side < 2; ++side)
    for (const Joint gill : {kGillTop, kGillMid, kGillLow})  // the wind
      bend(pose, on_side(gill, side), 0, side_sign(side) * 10, 0);
  const float squash = .035f * late;
  pose.scale[kBelly] = glm::vec3(1 + squash, 1 - squash, 1 + squash);
  bend(pose, kBelly, 7 * std::cos(2 * kTau * (phase - .27f)), 5 * std::cos(kTau * (phase - .08f)), 0);
  return pose;
}

void stand_on(Pose& pose, const Stand& left, const Stand& right, float apart = .28f) {
  plant_foot(pose, 0, left, {apart, 0, 1});
  plant_foot(pose, 1, right, {-apart, 0, 1});
}

// What the air does to it: arms, gills and tail float.
void float_about(Pose& pose, float phase) {
  for (int side = 0; side < 2; ++side) {
    bend(pose, on_side(kUpperArm, side), 0, 0, side_sign(side) * 5 * wave(phase, .1f));
    bend(pose, on_side(kForearm, side), 0, 0, side_sign(side) * 5 * wave(phase, .25f));
  }
  for (int i = 0; i < kTailCount; ++i) bend(pose, kTail1 + i, 3 * wave(phase, .08f * static_cast<float>(i)));
  flutter_gills(pose, phase, 9);
}

// Where both are at the ends of the leap.
constexpr float kLeapPhase = .25f;  // what the body's twist and sway are taken from: none, and to the left
const Stand kTrailing{{0, .055f, -.245f}, -62, 0}, kKneeUp{{0, .205f, .165f}, -24, 0};
const Stand kReaching{{0, .012f, .135f}, 6, 0}, kTucked{{0, .150f, -.135f}, -56, 0};
const Leap kUp{-.078f, -17, .80f, .3f, -8, 0};
const Leap kDown{-.022f, 2, 1.0f, .3f, 16, 0};

}  // namespace

Pose run_pose(float phase) {
  Pose pose = run_body(phase, {});
  stand_on(pose, running_foot(phase), running_foot(phase + .5f));
  return pose;
}

Pose rise_pose(float phase) {
  Pose pose = run_body(kLeapPhase, kUp);
  float_about(pose, phase);
  stand_on(pose, kKneeUp, kTrailing);
  return pose;
}

Pose fall_pose(float phase) {
  Pose pose = run_body(kLeapPhase, kDown);
  float_about(pose, phase);
  stand_on(pose, kReaching, kTucked);
  pose.gaze = turned(10, 0, 0);
  return pose;
}

Pose jump_pose(float share) {
  const float t = share * kJump_s, down = .25f * kRunRound_s;  // when the right foot comes down
  const float phase = .25f + t / kRunRound_s;
  Leap leap;
  leap.bob = 1 - ease(.05f, .20f, t);
  leap.crouch = passage({{0, 0}, {down - .03f, .004f}, {down + .085f, .068f}, {.47f, -.135f}}, t);
  leap.gather = passage({{0, 0}, {down, 6}, {down + .09f, 17}, {.44f, -27}}, t);
  leap.wings = passage({{0, 0}, {down, .04f}, {down + .10f, .10f}, {.44f, 1.05f}}, t);
  leap.swing = passage({{0, 1}, {down + .05f, .75f}, {kJump_s, .3f}}, t);
  leap.tail_up = passage({{0, 0}, {down + .10f, 14}, {kJump_s, -8}}, t);
  // Twist and sway come to rest.
  Pose pose = mix(run_body(phase, leap), run_body(kLeapPhase, leap), ease(.16f, kJump_s, t));
  pose.hips.y = -.036f - leap.crouch - .026f * leap.bob * std::cos(2 * kTau * (phase - .17f));
  Stand right = running_foot(phase + .5f);
  if (t > down) {
    right.shift = {0, 0, kRunFront - kRunSpeed * (t - down)};
    right.pitch = passage({{down, 9}, {down + .035f, 0}, {down + .10f, 0}, {.44f, -86}}, t);
  }
  const Stand left = mix(running_foot(phase), kKneeUp, ease(.12f, kJump_s, t));
  stand_on(pose, left, right);
  pose.way.z = kRunSpeed * t;
  return pose;
}

Pose land_pose(float share) {
  const float t = share * kLand_s, phase = t / kRunRound_s;
  Leap leap;
  const float begun = 1 - ease(0, .20f, t);  // what is left of the fall
  leap.bob = ease(.10f, .30f, t);
  leap.crouch = passage({{0, -.022f}, {.085f, .082f}, {.25f, .014f}, {kLand_s, 0}}, t);
  leap.gather = passage({{0, 2}, {.10f, 17}, {.30f, 2}, {kLand_s, 0}}, t);
  leap.wings = passage({{0, 1}, {.07f, .95f}, {.26f, .12f}, {kLand_s, 0}}, t);
  leap.swing = ease(.05f, .35f, t) * .7f + .3f;
  leap.tail_up = passage({{0, 16}, {.06f, 20}, {.19f, -16}, {.31f, 6}, {kLand_s, 0}}, t);
  Pose pose = mix(run_body(phase, leap), run_body(kLeapPhase, leap), begun);
  const float squash = passage({{0, 0}, {.10f, .11f}, {.20f, -.05f}, {.30f, 0}}, t);
  pose.scale[kBelly] *= glm::vec3(1 + squash, 1 - squash, 1 + squash);
  Stand left = running_foot(phase);
  left.pitch = mix({{}, running_foot(phase).pitch, 0}, {{}, 0, 0}, begun).pitch;
  if (t < .04f) left.pitch = passage({{0, 6}, {.04f, 0}}, t);
  const Stand right = mix(running_foot(phase + .5f), kTucked, begun);
  stand_on(pose, left, right);
  pose.gaze = turned(10 * begun, 0, 0);
  pose.way.z = kRunSpeed * t;
  return pose;
}

Pose start_pose(float share) {
  const float t = share * kStart_s, down = kStart_s - .25f * kWalkRound_s;  // when the left foot comes down
  const float phase = (t - down) / kWalkRound_s;
  if (t >= down) {
    Pose pose = walk_pose(phase);
    pose.way.z = .1f + kWalkSpeed * (t - down);
    return pose;
  }
  // It leans back to begin with, over the leg that stays, and falls forward onto the other.
  Pose pose = mix(idle_pose(0), walk_pose(phase), ease(0, down, t));
  const float back = passage({{0, 0}, {.13f, 1}, {.34f, 0}}, t);
  pose.hips += glm::vec3(-.020f * passage({{0, 0}, {.16f, 1}, {down, 0}}, t), -.010f * back, -.012f * back);
  bend_spine(pose, 5 * passage({{0, 0}, {.13f, -.8f}, {.30f, 1}, {down, 0}}, t), 0, 0);
  bend_head(pose, 5 * passage({{0, 0}, {.10f, .8f}, {.32f, -.9f}, {down, 0}}, t), 0, 0);
  const float u = t / down, u2 = u * u, u3 = u2 * u;
  pose.way.z = .1f * (3 * u2 - 2 * u3) + kWalkSpeed * down * (u3 - u2);
  const Stand to_left = walking_foot(0), to_right = walking_foot(.5f);
  Stand left, right;
  left.shift.z = .225f * ease(.10f, down, t) - pose.way.z;
  left.shift.y = passage({{.08f, 0}, {.27f, .055f}, {down, to_left.shift.y}}, t);
  left.pitch = passage({{.06f, 0}, {.20f, -26}, {.37f, 17}, {down, to_left.pitch}}, t);
  right.shift.z = -pose.way.z;
  right.pitch = passage({{.22f, 0}, {down + .04f, to_right.pitch}}, t);
  stand_on(pose, left, right);
  return pose;
}

Pose stop_pose(float share) {
  const float t = share * kStop_s, phase = .25f + t / kWalkRound_s, along = .13f;
  Pose pose = mix(walk_pose(phase), idle_pose(0), ease(.12f, .74f, t));
  const float u = std::min(t / .80f, 1.0f), u2 = u * u, u3 = u2 * u, end = .0125f + along;
  pose.way.z = end * (3 * u2 - 2 * u3) + kWalkSpeed * .80f * (u3 - 2 * u2 + u);
  // Everything but the feet goes on a little and comes back, the farther out the later.
  const auto settle = [&](float at) {
    return passage({{at, 0}, {at + .20f, 1}, {at + .42f, -.35f}, {at + .60f, 0}}, t);
  };
  pose.hips += glm::vec3(0, -.014f * settle(.16f), .016f * settle(.20f));
  bend_spine(pose, 8 * settle(.24f), 0, 0);
  bend_head(pose, 9 * settle(.30f) - 5 * settle(.16f), 0, 0);
  bend(pose, kBelly, 9 * settle(.30f));
  for (int side = 0; side < 2; ++side) {
    const glm::quat swing = turned(-10 * settle(.26f), 0, 0);
    pose.turn[static_cast<std::size_t>(on_side(kUpperArm, side))] =
        swing * pose.turn[static_cast<std::size_t>(on_side(kUpperArm, side))];
  }
  for (int i = 0; i < kTailCount; ++i) bend(pose, kTail1 + i, -3.5f * settle(.22f + .028f * static_cast<float>(i)));
  const Stand left0 = walking_foot(.25f), right0 = walking_foot(.75f);
  Stand left, right;
  const float far = right0.shift.z + (end - right0.shift.z) * ease(-.22f, .30f, t);
  right.shift = {0, passage({{-.06f, right0.shift.y}, {.30f, 0}}, t), far - pose.way.z};
  right.pitch = passage({{-.03f, right0.pitch}, {.20f, 13}, {.30f, 9}, {.39f, 0}}, t);
  left.shift.z = left0.shift.z + along * ease(.36f, .72f, t) - pose.way.z;
  left.shift.y = passage({{.38f, 0}, {.53f, .042f}, {.70f, 0}}, t);
  left.pitch = passage({{.16f, 0}, {.40f, -27}, {.54f, -14}, {.66f, 5}, {.74f, 0}}, t);
  stand_on(pose, left, right);
  return pose;
}

Pose turn_pose(float share) {
  const float t = share * kTurn_s;
  constexpr float kQuarter = 90;
  // Eyes and head are first, then the chest, hips and feet follow, the tail is last.
  const float eyes = ease(0, .30f, t), head = ease(.04f, .46f, t), chest = ease(.12f, .66f, t),
              hips = ease(.18f, .80f, t), tail = ease(.30f, 1.05f, t);
  Pose pose = idle_pose(0);
  pose.heading = kQuarter * hips;
  const float onto_right = passage({{.02f, 0}, {.24f, 1}, {.44f, .9f}, {.64f, -.9f}, {.82f, -.6f}, {1.05f, 0}}, t);
  pose.hips +=
      glm::vec3(-.030f * onto_right, -.012f * passage({{.05f, 0}, {.25f, 1}, {.48f, .3f}, {.68f, 1}, {1.0f, 0}}, t), 0);
  bend(pose, kPelvis, 0, 0, -3 * onto_right);
  const float lead = 60;  // the most that parts are ahead of one another
  bend_spine(pose, 3 * passage({{.1f, 0}, {.4f, 1}, {.95f, 0}}, t), lead * (chest - hips), 4 * onto_right);
  bend_head(pose, 6 * passage({{0, 0}, {.20f, 1}, {.46f, -.3f}, {.8f, 0}}, t), lead * (head - chest), -5 * onto_right);
  pose.gaze = turned(0, 26 * (eyes - head) + 8 * (head - hips), 0) * pose.gaze;
  for (int i = 0; i < kTailCount; ++i) {
    const float late = ease(.30f + .025f * static_cast<float>(i), 1.0f + .025f * static_cast<float>(i), t);
    bend(pose, kTail1 + i, 0, 11 * (.5f * (tail + late) - hips), 0);
  }
  for (int side = 0; side < 2; ++side) {
    const float out = passage({{.1f, 0}, {.45f, 1}, {1.05f, 0}}, t);
    bend(pose, on_side(kUpperArm, side), 0, -14 * (hips - ease(.26f, .95f, t)) - 0.0f, side_sign(side) * 11 * out);
  }
  const auto foot = [&](int side, float from, float to) {
    // Where it stands in the world, as the newt sees it: about the ball it turns, or about the heel.
    const float turned_by = ease(from, to, t) * kQuarter;
    Stand stand;
    stand.pitch = passage({{from - .10f, 0}, {from + .08f, -26}, {to - .06f, 6}, {to + .05f, 0}}, t);
    stand.yaw = turned_by - pose.heading;
    const glm::vec3 ankle = skeleton()[static_cast<std::size_t>(on_side(kFoot, side))].head;
    const glm::vec3 ball = skeleton()[static_cast<std::size_t>(on_side(kToes, side))].head;
    const glm::vec3 own = stand.pitch > 0 ? ankle + glm::vec3(0, -ankle.y, -.04f) : ball;
    stand.shift = turned(0, stand.yaw, 0) * own - own;
    stand.shift.y = passage({{from, 0}, {.5f * (from + to), .052f}, {to, 0}}, t);
    return stand;
  };
  stand_on(pose, foot(0, .20f, .52f), foot(1, .60f, .92f), .30f);
  return pose;
}

Pose hit_pose(float share) {
  const float t = share * kHit_s;
  Pose pose = idle_pose(0);
  const float blow = passage({{0, 0}, {.07f, 1}, {.13f, .85f}, {.30f, -.30f}, {.48f, .08f}, {.62f, 0}}, t);
  const float late = passage({{.02f, 0}, {.12f, 1}, {.20f, .8f}, {.40f, -.25f}, {.60f, .06f}, {.75f, 0}}, t);
  const float dizzy = passage({{.26f, 0}, {.36f, 1}, {.60f, .7f}, {.95f, 0}}, t);
  pose.hips.y -= .045f * late;
  bend_spine(pose, 20 * late, 0, 4 * dizzy * wave(t, .30f));
  bend_head(pose, 26 * blow, 20 * dizzy * wave(2.6f * t, .85f), 13 * dizzy * wave(2.6f * t, 1.0f));
  pose.scale[kHead] = glm::vec3(1 + .10f * blow, 1 - .15f * blow, 1 + .10f * blow);
  pose.scale[kNeck] = glm::vec3(1, 1 - .12f * blow, 1);
  const float fling = passage({{.01f, 0}, {.13f, 1}, {.27f, .85f}, {.62f, .1f}, {.85f, 0}}, t);
  for (int side = 0; side < 2; ++side) {
    aim_arm(pose, side, glm::mix(glm::vec3(.62f, -.78f, .05f), glm::vec3(.88f, .10f, .32f), fling),
            glm::mix(glm::vec3(-.1f, .1f, 1), glm::vec3(-.35f, 1, .5f), fling), 38 + 62 * fling);
    relax_hand(pose, side, 20 - 30 * fling);
    bend(pose, on_side(kClavicle, side), 0, 0, side_sign(side) * 16 * fling);
    bend(pose, on_side(kGillTop, side), -20 * late, 0, side_sign(side) * 24 * late);
    bend(pose, on_side(kGillMid, side), -12 * late, 0, side_sign(side) * 16 * late);
    bend(pose, on_side(kGillLow, side), 0, 0, side_sign(side) * -10 * late);
    plant_foot(pose, side, {}, {side_sign(side) * .42f, 0, 1});
  }
  for (int i = 0; i < kTailCount; ++i) {
    const float lag = .022f * static_cast<float>(i);
    bend(pose, kTail1 + i, passage({{.02f + lag, 0}, {.14f + lag, 8}, {.34f + lag, -3.5f}, {.55f + lag, 0}}, t));
  }
  bend(pose, kBelly, 14 * late);
  pose.gaze = turned(-8 * dizzy, 14 * dizzy * wave(2.6f * t, .6f), 0);
  return pose;
}

}  // namespace marrow::sample
