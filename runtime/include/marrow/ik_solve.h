// Inverse kinematics of any chain or tree of joints, by iteration: several goals at once, with a choice of methods.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"

namespace marrow {

// The methods of solve_ik(); docs/ik/solvers.md says which to take.
enum class IkMethod : std::uint8_t { fabrik, ccd, damped_least_squares, gauss_newton };

// A position for a point of a joint, a rotation for the joint, or both. A part of weight 0 is ignored. Where goals
// conflict, doubling a weight halves that part's error.
struct IkGoal {
  std::uint16_t joint = 0;           // of the skeleton
  std::uint8_t priority = 0;         // 0 is the most urgent; less urgent goals never disturb it. Jacobian methods only
  float offset[3] = {};              // the point of the joint that is to reach `position`; the joint's space, metres
  float position[3] = {};            // model space, metres
  float rotation[4] = {0, 0, 0, 1};  // of the joint's axes, in model space: a unit quaternion x, y, z, w
  float position_weight = 1;         // 0 … 100
  float rotation_weight = 0;         // metres a radian: an error of one radian counts as this many metres
};

// What solve_ik() is to do with a pose.
struct IkProblem {
  Span<const IkGoal> goals = {};          // at least one
  Span<const std::uint16_t> joints = {};  // the joints that may turn, in ascending order
  Span<const float> stiffness = {};  // one for each of `joints`: 0 turns freely … 1 not at all; empty: all are free
  // By joint in ascending order, as a skeleton's. Limits of joints that do not turn are ignored.
  Span<const JointLimit> limits = {};
  // The point towards which a chain with one goal bends, as a knee forward: the chain is turned about the line from its
  // first joint to the goal until its joints face this point. pole_weight is 0 … 1. FABRIK and CCD only.
  float pole[3] = {};     // model space, metres
  float pole_weight = 0;  // 0: no pole
  // Lets joints[0] move, such as the pelvis of a full body: moving it by this many metres is as easy as turning a joint
  // by a radian. 0: it stays. Jacobian methods only.
  float root_travel_m = 0;
};

// How solve_ik() solves.
struct IkOptions {
  IkMethod method = IkMethod::damped_least_squares;  // see docs/ik/solvers.md
  // The most poses to start from. The first is the given one; while the goals are not reached, others follow, with
  // joints turned at random by `seed`. For sets of limits in which a single start gets stuck in a corner. A goal out of
  // reach uses all starts and costs that many times as much; the result may jump as goals move.
  std::uint8_t starts = 1;
  std::uint16_t max_iterations = 16;  // in each start
  float tolerance_m = 1e-4f;          // iteration ends at an error (see IkReport) of no more than this
  float damping = 1;                  // for the Jacobian methods: more is calmer and slower
  std::uint32_t seed = 0;             // for `starts` and solve_ik_genetic: the same seed gives the same result
  float weight = 1;                   // 0 … 1: 0 changes no bit; between, rotations are blended
  // For FABRIK and CCD with one goal. If the goal is out of reach, the bones from the first joint that turns to the
  // goal's joint become longer by up to this factor; if it is too near, shorter. 1: bones keep their lengths. Changes
  // the local translations of joints on the way.
  float stretch = 1;
};

// Why a solver stopped.
enum class IkStop : std::uint8_t {
  reached,     // the error is less than the tolerance
  stalled,     // nothing moves any more: a goal is out of reach, or goals conflict
  iterations,  // max_iterations are used up
};

// How a solver ended.
struct IkReport {
  float error_m = 0;  // √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
  std::uint32_t iterations = 0;  // of all starts
  IkStop why = IkStop::reached;  // why it stopped
};

// Bytes of scratch memory that solve_ik needs; 0 if the problem's goals or joints cannot be read.
MARROW_API std::size_t ik_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem, const IkOptions& options);

// Turns the joints from the given pose so that the goals are reached, or as nearly as can be.
//
// Local rotations of problem.joints are changed, and the translation of joints[0] if it may travel; model_from_joint is
// updated for what hangs below. scratch: at least ik_scratch_bytes(), of any alignment. report: may be null. A joint's
// rotation in model space is the product of the rotations from the root down; scale has no part in it. Errors:
// bad_argument, and nothing is written, if a span is too short, an index is out of range, `joints` do not ascend, there
// are more than kMaxJoints goals, a goal hangs on no joint that turns, a number is not finite, a weight or a stiffness
// is out of range, or the pose is not finite on the way to a goal. Cost: docs/ik.md. Thread-safe on different poses and
// scratch.
MARROW_API Status solve_ik(const Pose& pose, const IkProblem& problem, const IkOptions& options,
                           Span<std::byte> scratch, IkReport* report = nullptr);

// solve_ik_chain has only FABRIK and CCD, solve_ik_body only the Jacobian methods, so that a game does not link the
// others. Both take scratch memory of ik_scratch_bytes(), which links little. Errors: as solve_ik, and bad_argument if
// options.method is one of the others.
MARROW_API Status solve_ik_chain(const Pose& pose, const IkProblem& problem, const IkOptions& options,
                                 Span<std::byte> scratch, IkReport* report = nullptr);
MARROW_API Status solve_ik_body(const Pose& pose, const IkProblem& problem, const IkOptions& options,
                                Span<std::byte> scratch, IkReport* report = nullptr);

// solve_ik by evolution, for sets of limits in which the other methods end in a corner. Too slow for every frame, and
// the result jumps as goals move. A function of its own, so that a game that does not call it does not link it.
//
// A memetic algorithm: poses compete by their error. The better ones are crossed and changed at random, and the best
// improve by cyclic coordinate descent. options.max_iterations counts generations, options.seed starts the random
// numbers. options.method, starts, damping and stretch are ignored, and so are the problem's pole and root travel.
// Every pose keeps to the limits. Joints of stiffness 1 stay; in crossing, all others turn alike. The
// same bits everywhere. Cost: tens of microseconds a generation, see docs/ik.md.
MARROW_API std::size_t ik_genetic_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem);
MARROW_API Status solve_ik_genetic(const Pose& pose, const IkProblem& problem, const IkOptions& options,
                                   Span<std::byte> scratch, IkReport* report = nullptr);

}  // namespace marrow
