// The tree that FABRIK, CCD, the Jacobian methods and the genetic solver all work on: the joints that turn and move a
// goal, and behind them a tip for each goal, which hangs on the joint that moves it and does not turn.
//
// Joints between that do not turn, translations and scales are folded into constant maps, so every node is one
// rotation: frame = parent's frame · above · rotation. A frame is a joint's space before its own scale, which is folded
// into what hangs below; frames are exact for any scale all the same.
#pragma once

#include "core/check.h"
#include "core/memory.h"
#include "ik/chance.h"
#include "ik/turn_joint.h"
#include "marrow/ik_solve.h"
#include "math/columns.h"

namespace marrow {

// What is read most often comes first: x86's short instructions reach 128 bytes.
struct IkNode {
  Columns frame;            // model_from_frame; of a tip: the origin is the point that shall reach the goal
  WideRotation rotation;    // the joint's local rotation
  f32x4 hinge;              // the only axis that it turns about, in its own axes; 0: any
  WideRotation turned;      // the frame's rotation in model space; kept only where goals ask for rotations
  const JointLimit* limit;  // or null
  float ease_root;          // √(1 - stiffness)
  std::uint16_t joint;      // of a tip: the goal's
  std::uint16_t parent;     // a node before this one; kNoJoint: nothing above moves
  Columns above;  // constant: from this joint's axes before they turn to the parent's frame, or to model space
  WideRotation above_turned;  // the rotation in `above`, or above the joint in model space
  WideRotation start;         // the rotation in the pose
  WideRotation best;          // the rotation of the best start so far
  Columns parent_from_frame;  // above · rotation
  const IkGoal* goal;         // of a tip
  std::uint16_t place;        // in IkProblem::joints
};

struct IkTree {
  Span<IkNode> nodes;          // those that turn, parents first
  Span<IkNode> tips;           // behind them in memory: one a goal, in their order
  std::uint16_t* node_of;      // for each joint of the skeleton its node, or kNoJoint
  bool turns = false;          // some goal asks for a rotation
  f32x4 travel = splat(0.0f);  // of node 0, in its parent joint's space; see IkProblem::root_travel_m
  float stretch = 1;           // factor on the bones below node 0, in a tree with one tip
};

// What solve_ik() is asked for.
struct IkCall {
  const Pose& pose;
  const IkProblem& problem;
  const IkOptions& options;
};

// A tree with room for its nodes and tips; the same calls with and without memory.
IkTree place_tree(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch);

// Fills it for a checked problem, frames and all. Bad if no joint that turns moves some goal, or the pose is not
// finite.
BadCall build_tree(const IkCall& call, IkTree& tree);

// Turns all joints at random from where the pose has them; see Chance::turn().
void begin_anew(IkTree& tree, Chance& chance, float size);

// Sets all frames after rotations changed.
void update_frames(IkTree& tree);
// Sets those of the tips alone.
void update_tips(IkTree& tree);
// Sets one frame from the parent's, and from parent_from_frame.
inline void follow_parent(const IkTree& tree, IkNode& node) {
  if (node.parent == kNoJoint) {
    node.frame = node.parent_from_frame;
  } else {
    multiply(tree.nodes[node.parent].frame, node.parent_from_frame, node.frame);
  }
}

// The rotation in model space of a node's axes before they turn.
inline WideRotation above_turned(const IkTree& tree, const IkNode& node) {
  return node.parent == kNoJoint ? node.above_turned : tree.nodes[node.parent].turned * node.above_turned;
}
// The axes of map · rotation.
inline void turn_axes(const Columns& map, WideRotation rotation, f32x4 (&out)[3]) {
  f32x4 axes[3];
  set_axes(rotation, axes);
  for (int a = 0; a < 3; ++a) out[a] = turn(map, axes[a]);
}

// From a tip to its goal's position; model space, metres.
inline f32x4 position_error(const IkNode& tip) {
  return load_wide(tip.goal->position) - tip.frame.origin;
}
// The turn that a tip lacks, as a rotation vector (axis times angle ≤ π) in model space.
f32x4 rotation_error(const IkNode& tip);

// See IkReport.
float total_error(const IkTree& tree);
// `sum`, squared errors of other tips, and that of a tip that is `apart` from its goal.
inline float with_error(float sum, const IkNode& tip, f32x4 apart) {
  const float p = tip.goal->position_weight, r = tip.goal->rotation_weight;
  sum += squared3(apart * p);
  return r > 0 ? sum + squared3(rotation_error(tip) * r) : sum;
}

// Sets a node's rotation: made a unit quaternion, and kept to the node's limit. Quite stiff nodes keep theirs.
void set_turned(IkNode& node, WideRotation rotation);

// Axis times angle, the angle at most π.
f32x4 turn_of(WideRotation q);

// Writes what changed into the pose, blended by `weight`, and brings the matrices below up to date.
void store_tree(const IkTree& tree, float weight, const Pose& pose);

// A method: changes rotations and frames of the tree. It takes its memory from `scratch`.
using IkSolver = void (*)(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);
void solve_heuristic(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);  // FABRIK and CCD
void solve_jacobian(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);   // the others

// Counts what a method takes: takes as much of no memory.
using IkCounter = void (*)(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
void count_heuristic(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
void count_jacobian(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
// What a call needs, tree and all, in memory of any alignment; 0 for a problem that cannot be read.
std::size_t scratch_bytes(IkCounter method, const Skeleton& skeleton, const IkProblem& problem);

// What all methods share: checks, the tree, the method, other starts, the pose written.
BadCall solve_ik_by(IkSolver solver, IkCounter counter, const IkCall& call, Span<std::byte> scratch, IkReport* report);

}  // namespace marrow
