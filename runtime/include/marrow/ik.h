// Inverse kinematics in closed form, for poses after local_to_model(). A limb of two bones reaches a point; a joint, or
// a chain of joints, looks at a point.
//
// Each comes in two forms. A kernel (two_bone, aim) takes model matrices and gives turns, to be multiplied onto the
// joints' local rotations from the right (local · turn); it knows no skeleton. A whole call (solve_...) takes a Pose,
// changes its local rotations, and updates the model matrices of all that hangs below. Both take the same struct.
//
// Every vector says its space: model space is that of model_from_joint, local space is the joint's own. Directions may
// be of any length. Results are exact under uniform scale, and for scales of the joints themselves. Under uneven scale
// of a joint above, a joint does not turn rigidly: kernels and aims are then approximate; solve_two_bone() stays exact.
// The same call gives the same bits on every processor. Thread-safe on different outputs; no allocation.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"

namespace marrow {

// The goal of a limb, whose joints are start, middle and end: hip, knee and ankle, say.
struct alignas(16) TwoBone {
  float target[3] = {0, 0, 0};  // where the end joint is to be; model space, metres
  float weight = 1;             // 0 … 1: 0 changes no bit, 1 reaches the target; between, both turns are blended
  // The direction from the start joint in which the middle joint is to point; model space. Zero: the middle joint stays
  // on its side in the pose, turned with the limb by the shortest arc. Within 0.1 rad of the target's direction the
  // pole counts less and less. There a second direction is mixed in: 37° from the side that the shortest arc alone
  // would give. So when the target passes over the pole, the limb swings round and does not jump.
  float pole[3] = {0, 0, 0};
  float twist_rad = 0;  // turns the limb about the line from start to target, on top of the pole; a few turns at most
  // The axis about which the middle joint bends by positive angles; in its local space. It decides how a straight limb
  // bends, and corrects a limb that the pose has bent the wrong way. Zero: the limb bends as in the pose, and a
  // straight limb bends towards the pole.
  float bend_axis[3] = {0, 0, 0};
  // 0 … 1: beyond this share of its length the limb straightens ever more slowly, so that the middle joint does not
  // snap when the target goes out of reach. 1: targets are reached exactly up to full length. 0.97 is a usual choice.
  float soft = 1;
  float max_stretch = 1;  // ≥ 1: for a target out of reach, the bones become longer by up to this factor
};

// The turns of a limb: unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
struct alignas(16) TwoBoneTurns {
  float start[4] = {0, 0, 0, 1};  // of the start joint
  float mid[4] = {0, 0, 0, 1};    // of the middle joint
  float stretch = 1;              // the factor on the translations of all joints below start, as far as end
  // Whether, at weight 1, the end joint comes within 1e-4 of the limb's length of the target.
  bool reached = false;
};

// The model matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
struct TwoBoneJoints {
  const Affine* start = nullptr;  // hip, shoulder
  const Affine* mid = nullptr;    // knee, elbow
  const Affine* end = nullptr;    // ankle, wrist
};

// Method: half-angles by the law of cosines from (s - x)(s + x) and (x - m)(x + m), with s and m the sum and difference
// of the bones' lengths, x the distance to the target; then the shortest arc to the target, and a turn about the
// target's direction, in one quaternion. A limb with a bone of no length is solved as far as it can be; nothing becomes
// infinite. A target at the start joint folds the limb.
//
// The turns refer to the axes of the given matrices, which include the joints' own scales. If a joint's own scale has
// negative components, the caller must change signs in its turn: of x where exactly one of the scale's y and z is
// negative, of y where exactly one of z and x is, of z where exactly one of x and y is. solve_two_bone() does so.
//
// Errors: bad_argument, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
// large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
// Cost: 416 instructions on x86-64, 326 on AArch64; twice that where the limb is nearly straight or bent the wrong way,
// the target is more than 140° off or near the pole, or there is a twist.
MARROW_API Status two_bone(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out);

// Solves four limbs at once, with the same bits, at 60 % of the instructions each. With fewer than four limbs, fill the
// rest with copies. Errors: as above; if one goal is bad, none is solved.
MARROW_API Status two_bone_x4(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4], TwoBoneTurns (&out)[4]);

// Joints of a skeleton; other joints may lie between them.
struct TwoBoneLimb {
  std::uint32_t start = 0, mid = 0, end = 0;  // hip, knee and ankle
};

// Solves a limb of a pose. Changes Pose::local and Pose::model_from_joint, unless the weight is 0. reached: may be
// null; see TwoBoneTurns. Errors: as above, and bad_argument if a span is too short or the joints are not a chain;
// nothing is written.
// Cost: the kernel's, and local_to_model_below(start). Under uneven scale, above the limb or of its start joint, the
// secant method finds the bend, and the limb is then turned: three to five times the cost, at most twelve. The target
// is still reached, or `reached` is false.
MARROW_API Status solve_two_bone(const Pose& pose, const TwoBoneLimb& limb, const TwoBone& goal,
                                 bool* reached = nullptr);

// The goal of a joint that looks or points at something: an eye, a head, a gun.
struct alignas(16) Aim {
  float target[3] = {0, 0, 0};  // model space, metres
  float weight = 1;             // 0 … 1: 0 changes no bit, 1 aims
  // The direction towards which `up` is turned about the line to the target; model space. Zero: the joint turns to the
  // target by the shortest arc. Within 0.1 rad of the target's direction the pole counts less and less, as a TwoBone's.
  float pole[3] = {0, 0, 0};
  float twist_rad = 0;           // turns about the line to the target, on top of the pole; a few turns at most
  float forward[3] = {0, 0, 1};  // the direction that is to point at the target; in the joint's local space
  float up[3] = {0, 1, 0};       // local, not along forward; ignored without a pole
  float offset[3] = {0, 0, 0};   // where forward begins: an eye before the head's joint; local
};

// What aim() gives.
struct alignas(16) AimTurn {
  float turn[4] = {0, 0, 0, 1};  // a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
  // Whether, at weight 1, the ray from the offset along forward goes through the target. It cannot in three cases: all
  // of the ray is farther from the joint than the target is; the target is at the joint; or forward has no length.
  bool reached = false;
};

// Method: takes the point of the ray that is as far from the joint as the target, and turns it onto the target by the
// shortest arc and a turn about it, in one quaternion.
// Errors: bad_argument, and nothing is written, for numbers that are not finite (or too large to be squared), or a
// weight outside 0 … 1.
// Cost: 226 instructions on x86-64, 180 on AArch64.
MARROW_API Status aim(const Affine& joint, const Aim& goal, AimTurn& out);

// Aims a joint of a pose. Changes Pose::local and Pose::model_from_joint, unless the weight is 0. reached: may be null.
// Errors: as above, and bad_argument if a span is too short or there is no such joint; nothing is written.
// Cost: the kernel's, and local_to_model_below(joint).
MARROW_API Status solve_aim(const Pose& pose, std::uint32_t joint, const Aim& goal, bool* reached = nullptr);

// Aims a chain of joints that share the turn, such as spine, neck and head. joints: each below the one before it in the
// skeleton. The last joint looks: forward, up and offset are in its space, and it makes the rest of the turn that the
// others leave. falloff: each joint's share of the turn, relative to the next joint's; 1: all alike, 0: the last joint
// alone.
// Errors: as above, and bad_argument if `joints` is empty or not a chain, or falloff not in 0 … 1.
MARROW_API Status solve_look_at(const Pose& pose, Span<const std::uint32_t> joints, const Aim& goal, float falloff,
                                bool* reached = nullptr);

}  // namespace marrow
