// Spring bones, for poses after local_to_model(): hair, tails and capes swing behind the animated pose.
//
// Chains and colliders are SpringChain and SpringCollider of file.h: a game's own, or an asset's by File::spring() and
// File::spring_colliders().
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"

namespace marrow {

inline constexpr float kMaxSpringStep_s = 1.0f / 60;  // a frame is cut into equal steps no longer than this
inline constexpr int kMaxSpringSteps = 8;             // the most steps of a frame; time beyond them is dropped
inline constexpr float kMinSpringFrame_s = 0.001f;    // shorter frames are added up until they are this long

// SpringGroup: settings and motion of four bones. SpringRoot: motion of one chain's first joint, and what its bones
// share. JointRange: joints with consecutive numbers. Plain bytes in the caller's memory, defined in
// springs/spring_state.h.
struct SpringGroup;
struct SpringRoot;
struct JointRange;

// The chains of one character. To keep or copy a motion, copy the memory.
struct Springs {
  SpringGroup* groups = nullptr;  // one for four bones
  SpringRoot* roots = nullptr;    // one a chain
  JointRange* below = nullptr;    // the joints whose matrices springs change
  std::uint32_t group_count = 0;  // length of groups
  std::uint32_t root_count = 0;   // length of roots
  std::uint32_t below_count = 0;  // length of below
  std::uint32_t joint_count = 0;  // of the skeleton
  float saved_s = 0;              // time of short frames, added up
};

// Bytes of memory that make_springs needs: 352 for four bones, 272 a chain, 2 a joint of the skeleton; 0 without
// chains.
MARROW_API std::size_t springs_bytes(const Skeleton& skeleton, Span<const SpringChain> chains);

// Makes springs in `memory`, which they use from then on. They begin at rest in the first pose.
//
// memory: at least springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
// Errors: bad_argument if a setting is out of its range, a joint is not in the skeleton or not below the one before it,
// a chain has no bone, or the memory is too small or off its boundary; nothing is written.
MARROW_API Status make_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Span<std::byte> memory,
                               Springs& out);

// Changes the settings, keeping the motion. Errors: as make_springs, and bad_argument if the joints are not the same.
MARROW_API Status set_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Springs& springs);

// Lets the springs begin anew: at rest in the next frame's pose.
MARROW_API void reset_springs(Springs& springs);

// What simulate_springs() is told of a frame.
struct SpringFrame {
  float dt_s = 0;  // since the last frame
  // The character's placement: a rotation, one uniform scale and a translation. Springs feel motion in the world, which
  // comes from this and from the pose.
  Affine world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  float gravity[3] = {0, -9.81f, 0};          // m/s², world
  float wind[3] = {0, 0, 0};                  // m/s, world; acts through SpringJoint::drag
  Span<const SpringCollider> colliders = {};  // at most kMaxSpringColliders
  float teleport_m = 1.0f;  // if a chain's first joint moves further in a frame, the chain moves rigidly
  bool teleported = false;  // true: all chains move rigidly in this frame
  float weight = 1.0f;      // 0 … 1, times each joint's
};

// Moves the springs on by a frame and bends the pose by them. Updates the matrices of what hangs below.
//
// pose: the animated one, in every frame: springs never read what they have written.
//
// Model. A bone is a damped pendulum about its joint. Its direction d in the world is a unit vector; u is the velocity
// of d:
//   du/dt = [ω² t + 2 ζ ω dt'/dt + (gravity - A) / L + drag (wind - V) / L] - (2 ζ ω + drag) u,
// without the part along d, which the bone bears: its length L never changes. ω is 2π SpringJoint::frequency_hz, ζ is
// SpringJoint::damping_ratio. t is the animated direction, turned with the bones above as they swing; t' is the
// animated direction alone. V and A are velocity and acceleration of the chain's first joint, from a parabola through
// its last three places. SpringJoint::most_pull, if set, limits how hard the first two terms together turn the bone:
// under a greater load it yields. The pull ω² t grows with the sine of the angle. So it is a linear spring's at small
// angles, and nothing at half a turn. A bone feels the bones above it; they do not feel it. So in a chain of equal
// bones, at their common frequency, a lower bone swings 1 / (2 ζ) as far as the one above: less if ζ is above ½. The
// joint turns by the shortest arc that takes the bone to its direction. A chain below a joint of another chain is
// carried along, but does not feel that chain's swing.
//
// Method. Equal steps of at most 1/60 s: kick, drift on a great circle, kick (Störmer-Verlet), with half of the damping
// before and half after. Drift and kicks are scaled so that small swings have the exact frequency and decay at any
// step. So the frame rate changes a path only through how it samples the animation. The energy |u|²/2 - F·d may grow by
// no more than the work done, so it never grows without input. The rotation that a bone hands down to the bones below
// takes its animated direction to its simulated one. Of all such rotations it is the one nearest to the rotation of the
// bone above: a projection (P. Davenport's matrix; see G. Wahba, SIAM Review 7(3), 1965), at the cost of one product of
// matrix and vector a joint.
//
// Under uneven scale above a joint directions are approximate, and lengths are kept. A bone shorter than a micrometre
// stays as it is. A joint of weight 0 keeps its bits; if all weights are 0, so do the matrices.
// Errors: bad_argument if a span is too short, the skeleton has another count of joints, a number is not finite or out
// of its range, or there are more than kMaxSpringColliders; nothing is written.
// Cost: at 60 frames/s 726 instructions a joint on x86-64; with colliders 110 more, and 110 for each. No allocation;
// thread-safe on different springs and poses.
MARROW_API Status simulate_springs(const Pose& pose, const SpringFrame& frame, Springs& springs);

}  // namespace marrow
