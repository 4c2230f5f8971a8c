// Spring bones in memory: settings and motion of four bones, and of one chain.
#pragma once

#include "marrow/springs.h"

namespace marrow {

inline constexpr std::uint16_t kNoBone = 0xFFFF;

inline constexpr float kAnyPull = 1e18f;  // stronger than any spring: no limit

// Four bones in the order of their chains, a lane each. Motion is in the world.
struct alignas(16) SpringGroup {
  // Motion.
  float direction[3][4];  // unit; 0: at rest in the next frame's pose
  float velocity[3][4];   // of the direction, 1/s; across it
  float animated[3][4];   // direction in the last frame's pose: unit, or 0 for a bone without length
  float bent[4][4];       // rotation from the animated to the simulated pose above the bone, of any length
  // Settings.
  float stiffness[4];  // ω², 1/s²
  float damping[4];    // 2 ζ ω, 1/s
  float drag[4];
  float gravity[4];
  float radius_m[4];
  float weight[4];
  float most_pull[4];  // 1/s²; kAnyPull: no limit
  // Places.
  std::uint16_t joint[4];  // kNoBone: the lane is empty
  std::uint16_t end[4];    // joint at the bone's end; kNoBone: the chain's tip is there
  std::uint16_t root[4];   // the number of its chain
};

// Joints first … end - 1.
struct JointRange {
  std::uint16_t first, end;
};

// What a chain feels of the character's motion. Arrays of four are rows to be transposed.
struct alignas(16) SpringRoot {
  float turn[3][3];                      // turns the chain rigidly, if `moved`
  float position[3];                     // of the first joint, in the last frame
  float velocity[3];                     // of the first joint, at the end of the last frame
  float mean_velocity[3];                // of the first joint, over the last frame
  float frame_s;                         // length of the last frame
  float tip[3];                          // SpringChain::tip
  std::uint32_t frames;                  // since the motion began, up to 2
  std::uint32_t first;                   // joint
  std::uint32_t shown;                   // whether any weight is above 0
  std::uint32_t moved;                   // the chain is moved rigidly in this frame
  std::uint64_t colliders;               // SpringChain::colliders
  alignas(16) float air[2][4];           // wind - V at both ends of this frame
  alignas(16) float acceleration[2][4];  // at both ends of this frame
  Affine parent;                         // model_from_joint of the joint above the chain, in the last frame
  Affine world;                          // world_from_model of the last frame
};

static_assert(sizeof(SpringRoot) == 272);

}  // namespace marrow
