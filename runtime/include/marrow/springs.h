// Stage 3½, spring bones: hair, tails and capes swing behind the animated pose.
//
// Chains and colliders are SpringChain and SpringCollider in file.h: a game's own, or those that an asset came with,
// File::spring() and File::spring_colliders().
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

inline constexpr float kMaxSpringStep_s = 1.0f / 60;  // frames are cut into equal steps no longer than this …
inline constexpr int kMaxSpringSteps = 8;             // … and time beyond so many is left out
inline constexpr float kMinSpringFrame_s = 0.001f;    // shorter frames are saved up

// Four bones and one chain: settings and motion, plain bytes in the caller's memory. Defined in springs/spring_state.h.
struct SpringGroup;
struct SpringRoot;
struct JointRange;

// Chains of one character. To keep or to copy a motion, copy the memory.
struct Springs {
  SpringGroup* groups = nullptr;  // four bones each
  SpringRoot* roots = nullptr;    // a chain each
  JointRange* below = nullptr;    // joints whose matrices springs change
  std::uint32_t group_count = 0;  // of each of them
  std::uint32_t root_count = 0;   // likewise
  std::uint32_t below_count = 0;  // likewise
  std::uint32_t joint_count = 0;  // of the skeleton
  float saved_s = 0;              // time of frames that were too short
};

// What make_springs needs: 352 bytes for four bones, 272 a chain, 2 a joint of the skeleton; 0 without chains.
MARROW_API std::size_t springs_bytes(const Skeleton& skeleton, Span<const SpringChain> chains);

// Lays springs out in `memory`, which they use from then on, at rest in whatever pose comes first.
//
// memory: at least springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
// Errors: bad_argument if a setting is out of its range, a joint is not in the skeleton or not below the one before it,
// a chain has no bone, or the memory does not do; nothing is written.
MARROW_API Status make_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Span<std::byte> memory,
                               Springs& out);

// New settings for the same joints, in the midst of motion. Errors: as make_springs, or not the same joints.
MARROW_API Status set_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Springs& springs);

// The next frame begins at rest in its pose.
MARROW_API void reset_springs(Springs& springs);

// What simulate_springs() is told of a frame.
struct SpringFrame {
  float dt_s = 0;  // since the last frame
  // Where the character stands: a turn, one scale, a shift. Motion in the world is felt, by this and by the pose.
  Affine world_from_scene = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  float gravity[3] = {0, -9.81f, 0};          // m/s², world
  float wind[3] = {0, 0, 0};                  // m/s, world; acts by `drag`
  Span<const SpringCollider> colliders = {};  // at most kMaxSpringColliders
  float teleport_m = 1.0f;  // chains whose first joint moves further than this in one frame are moved along …
  bool teleported = false;  // … and so are all if this is set
  float weight = 1.0f;      // 0 … 1, times each joint's
};

// Moves the springs on by a frame and bends `local` by them; the matrices of what hangs below are brought up to date.
//
// local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count; local_to_model() has made
// the one from the other. Springs never read what they have written: give them the animated pose of every frame.
//
// Model. A bone is a damped pendulum about its joint: for its direction d in the world, a unit vector of velocity u,
//   du/dt = [ω² t + 2 ζ ω dt'/dt + (gravity - A) / L + drag (wind - V) / L] - (2 ζ ω + drag) u,
// of which the part along d is borne by the bone, whose length L never changes. t is the animated direction, turned
// with the bones above it as they swing; t' the same without what those do; V and A are velocity and acceleration of
// the chain's first joint, from a parabola through its last three places. The first two terms together turn the bone no
// harder than SpringJoint::most_pull, if that is set: a load that is more makes it yield. The pull ω² t is in
// proportion to the sine of the angle: as much as a linear spring's for small ones, nothing at half a turn. A bone
// feels those above it, they do not feel it; so of equal bones in a chain the lower swings 1 / (2 ζ) as far at the
// common frequency, less than the upper from ζ = ½ on. A turn of the joint is the shortest that takes the bone there. A
// chain below another's joint is carried by it, but does not feel its swing.
//
// Method. Equal steps of at most 1/60 s: kick, drift on a great circle, kick (Störmer-Verlet), half of the damping
// before and half after. Drift and kicks have the strengths with which small swings have the exact frequency and decay,
// whatever the step; so a path does not depend on the frame rate but for how the animation's frames cut its curves. The
// energy |u|²/2 - F·d is held down to the work done, so that it never grows without input.
// What hangs on a bone turns by the nearest rotation to its parent's that takes the one direction to the other, which
// is a projection (P. Davenport's matrix; see G. Wahba, SIAM Review 7(3), 1965) and costs one product of matrix and
// vector a joint.
//
// Scales that are not one scale, above a joint: directions are then approximate, lengths still kept. A bone shorter
// than a micrometre stays as it is. A weight of 0 leaves the bits of a joint, and, all 0, those of the matrices.
// Errors: bad_argument if a span is too short, the skeleton has another count of joints, a number is not finite or out
// of its range, or there are more than kMaxSpringColliders; nothing is written.
// Cost: at 60 frames/s 726 instructions a joint on x86-64; with colliders 110 more, and 110 for each. No allocation;
// thread-safe on different springs and poses.
MARROW_API Status simulate_springs(const Skeleton& skeleton, const SpringFrame& frame, Springs& springs,
                                   Span<SoaTransform> local, Span<Affine> scene_from_joint);

}  // namespace marrow
