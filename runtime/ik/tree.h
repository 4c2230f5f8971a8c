// What the iterative solvers work on: the joints that turn and move a goal, and nothing of the skeleton besides.
//
// Joints between that do not turn, translations and scales are folded into constant maps, so that every node is one
// rotation: frame = frame of the parent node · above · rotation. A frame is a joint's space before its own scale, which
// is folded into what hangs below; frames are exact for any scale all the same.
#pragma once

#include "core/check.h"
#include "core/memory.h"
#include "ik/chance.h"
#include "ik/turn_joint.h"
#include "marrow/ik_solve.h"
#include "math/columns.h"

namespace marrow {

// What is asked for most often comes first: the shortest instructions reach 128 bytes.
struct IkNode {
  Columns frame;            // scene_from_frame
  WideRotation rotation;    // the joint's local rotation
  f32x4 hinge;              // the only axis that it turns about, in its own axes; 0: any
  WideRotation turned;      // of the frame in the scene; where goals ask for rotations only
  const JointLimit* limit;  // or null
  float ease_root;          // √(1 - stiffness)
  std::uint16_t joint;
  std::uint16_t parent;  // a node, before this one; kNoParent: what is above never moves
  Columns above;         // constant: from this joint's axes before they turn to the parent node's frame, or the scene
  WideRotation above_turned;  // the rotation in `above`, or of what is above it in the scene
  WideRotation start;         // the rotation as it was in the pose
  WideRotation best;          // of all starts so far
  Columns parent_from_frame;  // above · rotation
  std::uint16_t place;        // in IkProblem::joints
};

// The end of a chain: one a goal.
struct IkEnd {
  const IkGoal* goal;
  f32x4 point;            // that shall reach the goal, in the node's frame
  f32x4 bone;             // of `point` the part that is translations of joints, and not the goal's offset
  WideRotation rotation;  // from the goal's joint to the node's axes
  std::uint16_t node;
};

struct IkTree {
  Span<IkNode> nodes;          // ascending: parents first
  Span<IkEnd> ends;            // as IkProblem::goals
  std::uint16_t* node_of;      // of each of the skeleton's joints: its node or kNoParent
  bool turns = false;          // some goal asks for a rotation
  f32x4 travel = splat(0.0f);  // of node 0, in its parent joint's space; see IkProblem::root_travel_m
  float stretch = 1;           // of the bones below node 0, of a tree with one end
};

// What solve_ik() is asked for.
struct IkCall {
  PosedJoints pose;
  const IkProblem& problem;
  const IkOptions& options;
};

// A tree with room for its nodes and ends; the same calls with and without memory.
IkTree place_tree(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch);

// Of a checked problem, frames and all. Bad if a goal hangs on no joint that turns, or the pose is not finite.
BadCall build_tree(const IkCall& call, IkTree& tree);

// Joints turned at random from where the pose has them; see Chance::turn().
void begin_anew(IkTree& tree, Chance& chance, float size);

// Frames of the nodes, after rotations changed.
void update_frames(IkTree& tree);

// Rotation in the scene of a node's axes before they turn.
inline WideRotation above_turned(const IkTree& tree, const IkNode& node) {
  return node.parent == kNoParent ? node.above_turned : tree.nodes[node.parent].turned * node.above_turned;
}
// Axes of a map, turned before it.
inline void turn_axes(const Columns& map, WideRotation rotation, f32x4 (&out)[3]) {
  f32x4 axes[3];
  set_axes(rotation, axes);
  for (int a = 0; a < 3; ++a) out[a] = turn(map, axes[a]);
}

// From where an end is to where it shall be: scene space, metres.
inline f32x4 position_error(const IkTree& tree, const IkEnd& end) {
  return load_wide(end.goal->position) - transform(tree.nodes[end.node].frame, end.point);
}
// The turn that is missing, as a rotation vector (axis times angle ≤ π) in scene space.
f32x4 rotation_error(const IkTree& tree, const IkEnd& end);

// See IkReport.
float total_error(const IkTree& tree);
// `sum`, the squares of other ends' errors, with those of an end that is so far from where it shall be.
inline float with_error(float sum, const IkTree& tree, const IkEnd& end, f32x4 apart) {
  const float p = end.goal->position_weight, r = end.goal->rotation_weight;
  sum += squared3(apart * p);
  return r > 0 ? sum + squared3(rotation_error(tree, end) * r) : sum;
}

// Of unit length, and kept to the node's limit. A node that is quite stiff keeps its rotation.
void set_turned(IkNode& node, WideRotation rotation);

// Axis times angle, the angle at most π.
f32x4 turn_of(WideRotation q);

// Writes what changed into the pose, blended by `weight`, and brings the matrices below up to date.
void store_tree(const IkTree& tree, float weight, const PosedJoints& pose);

// A method: changes rotations and frames of the tree. It takes what memory it needs of `scratch`.
using IkSolver = void (*)(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);
void solve_heuristic(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);  // FABRIK and CCD
void solve_jacobian(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report);   // the others

// Takes as much as a method does, of no memory: counts it.
using IkCounter = void (*)(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
void count_heuristic(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
void count_jacobian(const Skeleton& skeleton, const IkProblem& problem, Memory& count);
// What calls need, the tree and all, of memory of any alignment; 0 of a problem that cannot be read.
std::size_t scratch_bytes(IkCounter method, const Skeleton& skeleton, const IkProblem& problem);

// What is the same for all methods: checks, the tree, the method, other starts, the pose written.
BadCall solve_ik_by(IkSolver solver, IkCounter counter, const IkCall& call, Span<std::byte> scratch, IkReport* report);

}  // namespace marrow
