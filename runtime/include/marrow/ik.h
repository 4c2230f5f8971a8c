// Stage 3½, inverse kinematics in closed form: a limb of two bones reaches for a point, a joint or a chain of them
// looks at one.
//
// Each comes in two forms. A kernel takes scene matrices and gives turns of joints, to be multiplied onto their local
// rotations from the right (local · turn); it knows no skeleton. A whole call takes a pose, changes local rotations and
// brings the scene matrices of all that hangs below up to date. What both are asked is one plain struct.
//
// Vectors named "scene" are in the space of scene_from_joint, "local" ones in the joint's own; neither need be of unit
// length. Uniform scales, and scales of the joints themselves, are exact. Joints scaled unevenly from above are not
// rigid when they turn: kernels and aims come near only; solve_two_bone() reckons with it. The same call gives the same
// bits on every processor.
// Thread-safe on different outputs; no allocation.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// What is asked of a limb: start, middle and end joint, such as hip, knee and ankle.
struct alignas(16) TwoBone {
  float target[3] = {0, 0, 0};  // where the end joint is to be; scene, metres
  float weight = 1;             // 0 … 1: 0 changes no bit, 1 reaches; between, both turns are blended
  // The direction, from the start joint, to whose side the middle joint points; scene. Zero: the side it has in the
  // pose, carried along the shortest way. Less than 0.1 rad off the direction of the target a pole says little, and
  // the answer goes over to a side of 37° from that of the pose: a target that goes over the pole in the plane of the
  // pose swings the limb round, and does not make it jump.
  float pole[3] = {0, 0, 0};
  float twist_rad = 0;  // turns the limb about the line from start to target, away from the pole; a few turns at most
  // About what the middle joint bends, by positive angles; in its local space. Says which way a straight limb bends,
  // and which way it is to bend if the pose has it bent the other way. Zero: as in the pose, and a straight limb
  // towards the pole.
  float bend_axis[3] = {0, 0, 0};
  // The share of the limb's length from which on it stretches ever more slowly, 0 … 1, so that the middle joint does
  // not snap when the target goes out of reach. 1: straight to full stretch, and the target is reached exactly to
  // there; 0.97 is a usual choice.
  float soft = 1;
  float max_stretch = 1;  // ≥ 1: the bones may be this many times as long, if the target is reached no other way
};

// Unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
struct alignas(16) TwoBoneTurns {
  float start[4] = {0, 0, 0, 1};  // of the start joint
  float mid[4] = {0, 0, 0, 1};    // of the middle joint
  float stretch = 1;  // for the translations of all joints from below start down to end; 1: unless max_stretch > 1
  // The target is within reach: at weight 1 the end comes to it within 1e-4 of the limb's length.
  bool reached = false;
};

// The scene matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
struct TwoBoneJoints {
  const Affine* start = nullptr;  // hip, shoulder
  const Affine* mid = nullptr;    // knee, elbow
  const Affine* end = nullptr;    // ankle, wrist
};

// Method: the law of cosines in half-angles from lengths, (s - x)(s + x) and (x - m)(x + m), s and m the sum and the
// difference of the lengths; then the shortest arc to the target and a turn about it, in one quaternion.
// Of a bone of no length the rest is still done; nothing becomes infinite. A target at the start joint folds the limb.
// The turns are about the axes of the matrices. Where a joint's own scale mirrors it, its turn's x changes sign if just
// one of that scale's y and z is negative, y by z and x, z by x and y; the whole call does so.
// Errors: bad_argument, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
// large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
// Cost: 400 instructions on x86-64, 326 on AArch64; about as much again where the limb is nearly straight or bent the
// wrong way, the target more than 140° off or near the pole, or there is a twist.
MARROW_API Status two_bone(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out);

// Four limbs at once, to the same numbers, at 60 % of the instructions each. Fill up with copies.
// Errors: as above, for all four if one is bad.
MARROW_API Status two_bone_x4(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4], TwoBoneTurns (&out)[4]);

// Joints of a skeleton; other joints may lie between them.
struct TwoBoneLimb {
  std::uint32_t start = 0, mid = 0, end = 0;  // hip, knee and ankle
};

// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
// 0. reached: may be null; see TwoBoneTurns. Errors: as above, and bad_argument if a span is too short or the joints
// are not a chain; nothing is written. Cost: the kernel's, and local_to_model_below(start).
// Where the limb changes its shape as it turns, by uneven scale above it or of its start joint, it is bent by secants
// and then turned: three to five times the cost, at most twelve. The target is met nevertheless; reached says if not.
MARROW_API Status solve_two_bone(const Skeleton& skeleton, const TwoBoneLimb& limb, const TwoBone& goal,
                                 Span<SoaTransform> local, Span<Affine> scene_from_joint, bool* reached = nullptr);

// What is asked of a joint that looks or points at something: an eye, a head, a gun.
struct alignas(16) Aim {
  float target[3] = {0, 0, 0};  // scene, metres
  float weight = 1;             // 0 … 1: 0 changes no bit, 1 aims
  // The scene direction to whose side of the target's direction `up` is turned. Zero: nothing is; the shortest way to
  // the target is taken. Less than 0.1 rad off the target's direction it says little, as a TwoBone's pole.
  float pole[3] = {0, 0, 0};
  float twist_rad = 0;           // turns about the direction of the target, on top; a few turns at most
  float forward[3] = {0, 0, 1};  // what is to go through the target; in the joint's local space
  float up[3] = {0, 1, 0};       // local; not along forward. Of no use without a pole
  float offset[3] = {0, 0, 0};   // where forward begins: an eye before the head's joint; local
};

// What aim() gives.
struct alignas(16) AimTurn {
  float turn[4] = {0, 0, 0, 1};  // a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
  // The target can be seen: at weight 1 the ray from the offset along forward goes through it. It cannot where the
  // target is nearer to the joint than the ray ever gets, or than the offset, or where forward has no length.
  bool reached = false;
};

// Method: the point where the ray is as far from the joint as the target is turned onto it by the shortest arc and a
// turn about it, in one quaternion.
// Errors: bad_argument, and nothing is written, for numbers that are not finite (or too large to be squared), or a
// weight outside 0 … 1.
// Cost: 219 instructions on x86-64, 180 on AArch64.
MARROW_API Status aim(const Affine& joint, const Aim& goal, AimTurn& out);

// The whole call. local and scene_from_joint belong together (local_to_model); both are changed, unless the weight is
// 0. reached: may be null. Errors: as above, and bad_argument if a span is too short or there is no such joint; nothing
// is written. Cost: the kernel's, and local_to_model_below(joint).
MARROW_API Status solve_aim(const Skeleton& skeleton, std::uint32_t joint, const Aim& goal, Span<SoaTransform> local,
                            Span<Affine> scene_from_joint, bool* reached = nullptr);

// The same for a chain that shares the turn, such as spine, neck and head: joints from the lowest up to the one that
// looks, each below the one before it, whose forward, up and offset are meant; it does what the others leave.
// falloff: each joint's share of the turn, of what the next one has; 1: all alike, 0: the last alone.
// Errors: as above, and bad_argument if `joints` is empty or not a chain, or falloff not in 0 … 1.
MARROW_API Status solve_look_at(const Skeleton& skeleton, Span<const std::uint32_t> joints, const Aim& goal,
                                float falloff, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                                bool* reached = nullptr);

}  // namespace marrow
