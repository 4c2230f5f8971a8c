// Inverse kinematics of any chain or tree of joints, by iteration: several goals at once, one interface for all
// methods.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// How solve_ik() solves; docs/ik/solvers.md says which is for what.
enum class IkMethod : std::uint8_t { fabrik, ccd, damped_least_squares, gauss_newton };

// Where a point of a joint shall be, how the joint shall be turned, or both. What counts of a goal is its weights: 0
// and it does not, of twice the weight and it gives way half as far where goals contradict each other.
struct IkGoal {
  std::uint16_t joint = 0;    // of the skeleton
  std::uint8_t priority = 0;  // 0 first; what is less urgent never disturbs what is more so. Jacobian methods only
  float offset[3] = {};       // the point of the joint that shall reach `position`; the joint's space, metres
  float position[3] = {};     // scene space, metres
  float rotation[4] = {0, 0, 0, 1};  // of the joint's axes, in scene space: a unit quaternion x, y, z, w
  float position_weight = 1;         // 0 … 100
  float rotation_weight = 0;         // metres a radian: the distance that is as bad as being turned wrong by a radian
};

// What is asked of a pose.
struct IkProblem {
  Span<const IkGoal> goals = {};          // at least one that counts
  Span<const std::uint16_t> joints = {};  // that may turn: ascending, so that parents come first. Others are stiff
  Span<const float> stiffness = {};  // one of each of `joints`: 0 turns freely … 1 not at all; empty: all are free
  // Joints ascending, as in a skeleton; those of joints that do not turn are left out.
  Span<const JointLimit> limits = {};
  // Where a chain with one goal shall bend to, as a knee forward: the middle of its joints faces this point as nearly
  // as a turn about the line from the first joint to the goal lets it. Of weight 0 … 1. FABRIK and CCD only.
  float pole[3] = {};     // scene space, metres
  float pole_weight = 0;  // 0: no pole
  // By how many metres joints[0] is moved as easily as a joint is turned by a radian: the pelvis of a full body. 0: it
  // stays. Jacobian methods only.
  float root_travel_m = 0;
};

// How it is solved.
struct IkOptions {
  IkMethod method = IkMethod::damped_least_squares;  // see docs/ik/solvers.md
  // How many poses to start from at most, as long as the goals are not reached: the one that there is, then others in
  // which joints are turned at random, by `seed`. For sets of limits in which one start ends in a corner. More than 1
  // costs as many times as much where goals are out of reach, and the result may jump as goals move.
  std::uint8_t starts = 1;
  std::uint16_t max_iterations = 16;  // the most there are
  float tolerance_m = 1e-4f;          // an error (see IkReport) of less ends the iteration
  float damping = 1;                  // of the Jacobian methods: more is calmer and slower
  std::uint32_t seed = 0;             // of `starts` and of solve_ik_genetic: the same seed, the same result
  float weight = 1;                   // 0 leaves every bit as it was; between, rotations lie between
  // Of FABRIK and CCD with one goal: where it is beyond reach, the bones from the first joint that turns to the goal's
  // become longer, by up to this factor; and shorter, by up to as much, where it is too near for them. 1: they keep
  // their lengths. Changes local translations of the joints on the way.
  float stretch = 1;
};

// Why a solver stopped.
enum class IkStop : std::uint8_t {
  reached,     // the error is less than the tolerance
  stalled,     // nothing moved any more: the target is out of reach, or goals contradict each other
  iterations,  // max_iterations are over
};

// How a solver ended.
struct IkReport {
  float error_m = 0;  // √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
  std::uint32_t iterations = 0;  // that it took
  IkStop why = IkStop::reached;  // why it took no more
};

// Bytes of scratch memory that solve_ik needs; 0 of a problem without goals or joints that could be read.
MARROW_API std::size_t ik_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem, const IkOptions& options);

// Turns the joints so that the goals are reached, or as nearly as may be, starting from the pose that is there.
//
// local: at least skeleton.soa_size(), parent_from_joint; changed: rotations of problem.joints, and the translation of
// joints[0] if it may travel. scene_from_joint: at least skeleton.joint_count, of this pose (local_to_model); brought
// up to date for what hangs below the joints that turn. scratch: at least ik_scratch_bytes(), of any alignment. report:
// may be null.
// A rotation in scene space is the product of the rotations from the root down; scale has no part in it.
// Errors, and nothing is written: bad_argument if a span is too short, an index out of range, `joints` not ascending,
// there are more than kMaxJoints goals, or a goal that no joint turns, a number not finite, a weight or a stiffness out
// of range, or the pose not finite on the way to a goal.
// Cost: docs/ik.md. Thread-safe on different poses and scratch.
MARROW_API Status solve_ik(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                           const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                           IkReport* report = nullptr);

// The same with FABRIK and CCD alone, and with the Jacobian methods alone: what is not named is not linked. Scratch
// memory is that of ik_scratch_bytes(), which links little. Errors: as solve_ik, or options.method is one of the
// others.
MARROW_API Status solve_ik_chain(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                                 const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                                 IkReport* report = nullptr);
MARROW_API Status solve_ik_body(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                                const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                                IkReport* report = nullptr);

// The same by evolution, for sets of limits in which the other methods end in a corner; too slow for every frame, and
// the result jumps as goals move. A function of its own, so that what does not call it does not link it.
//
// A memetic algorithm: poses compete by their error; joints of the better ones are crossed and changed at random, and
// the best learn by cyclic coordinate descent. options.max_iterations are generations, options.seed what chance begins
// with; options.method, starts, damping and stretch, and the problem's pole and root travel, have no meaning. Each pose
// keeps to limits; stiff joints stay, and what is less stiff turns as any other. The same bits everywhere. Cost:
// docs/ik.md: tens of microseconds a generation.
MARROW_API std::size_t ik_genetic_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem);
MARROW_API Status solve_ik_genetic(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                                   const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                                   IkReport* report = nullptr);

}  // namespace marrow
