// What FABRIK and CCD keep beside the tree: where its points are to go, and how much each goal weighs.
#pragma once

#include "ik/tree.h"

namespace marrow {

// What a goal asks for.
struct IkAim {
  const IkNode* tip;
  f32x4 goal;             // the position to reach; in place of one out of reach, the nearest that is in reach
  WideRotation rotation;  // the rotation in model space that the tip's node is to have
  float position, turn;   // the weights squared, relative to the greatest; a radian counts as the tree's length
};

// The points of the tree: one for each node, and behind those one for each tip. What hangs on a node is a list.
struct IkPart {
  f32x4 at;                 // where the point is, or where it is wanted; model space
  f32x4 before;             // what an iteration changes, before it; CCD: of a tip its node's rotation in model space
  float length = 0;         // from the node that it hangs on
  float weight = 0;         // of the positions to be reached by it and what hangs on it
  float share = 0;          // of all weight that hangs on the same node
  IkAim* aim = nullptr;     // of a tip
  const f32x4* bone;        // from the node that it hangs on to there, in that node's axes
  IkPart* on = nullptr;     // the node that it hangs on, if any
  IkPart* next = nullptr;   // the next that hangs on the same node
  IkPart* first = nullptr;  // the first that hangs on it; CCD: the node that moves a tip now
};

struct IkHeuristic {
  IkTree* tree;
  Span<IkPart> parts;  // of the nodes, and behind them of the tips
  IkPart* tips;        // the parts behind the nodes'
  IkAim* aims;
  float size_m = 0;    // sum of all lengths
  float per_size = 0;  // 1 / size_m; 0 for no size
  bool free = true;    // neither limits nor stiffness
  bool chain = false;  // one tip, with a position to reach
  bool plain = false;  // a free chain without a rotation to reach: only points move, joints turn at the end
  WideRotation turned = no_turn();  // how a plain chain has turned as a whole; model space

  Span<IkPart> of_tips() const { return {tips, tree->tips.size}; }
  // Of a chain, which goes on from one part to the next: without the root; and without root and tip.
  Span<IkPart> below_root() const { return {parts.data + 1, parts.size - 1}; }
  Span<IkPart> between() const { return {parts.data + 1, parts.size - 2}; }
};

// v made so long; 0 if v has no direction. Root and quotient do not wait for each other.
inline f32x4 along(f32x4 v, float length) {
  const float squared = squared3(v);
  return v * (has_direction(squared) ? length * (sqrt(squared) * (1.0f / squared)) : 0.0f);
}

// Takes its memory and sets positions, lengths and weights from the tree.
IkHeuristic set_up(IkTree& tree, Memory& scratch);

// A weighted sum of turns. A quaternion that is not a unit weighs more the longer it is.
struct TurnSum {
  void add(WideRotation q, float w);
  // Adds the shortest turn from one direction to another; nothing if one of them is 0.
  void add_arc(f32x4 from, f32x4 to, float w);
  // Adds the turn about a hinge that takes one direction nearest to another; the shortest turn if the hinge is 0.
  void add_arc_about(f32x4 hinge, f32x4 from, f32x4 to, float w);
  WideRotation turn() const;  // not of unit length

  f32x4 sum = splat(0.0f);
  f32x4 across = splat(0.0f);  // the axis of half a turn, taken where the turns cancel each other
  float weight = 0;
};

// The inverse of the linear part of a frame.
struct InverseAxes {
  explicit InverseAxes(const f32x4 (&axis)[3]);
  // The product but for a factor above 0: waits for no division.
  f32x4 direction(f32x4 v) const { return products(cofactor, v) * sign; }
  f32x4 operator*(f32x4 v) const { return direction(v) * scale; }
  f32x4 cofactor[3];
  float sign, scale;
  bool exists;
};

// The part `share` of a turn, the shorter way round. any: of any length, and returned as it is if share is 1.
WideRotation part_of(WideRotation any, float share);
float total_length(const IkHeuristic& h);
// Sets positions and lengths of all parts from the frames.
void update_parts(IkHeuristic& h);
// Sets the frames from the rotations, and then the parts.
void update(IkHeuristic& h);

// Prepares a chain with one tip: stretches its bones, and moves a goal that is out of reach into reach. Returns how far
// the chain is to be straightened: 0 for a goal in reach, 1 for one that is clearly too far.
float approach(IkHeuristic& h, const IkOptions& options);
// Turns the whole chain towards the goal, before the first iteration, and moves the points off a straight line to it.
void set_out(IkHeuristic& h);
// Turns the chain about the line from its root to its tip until it bends towards the pole.
void face_pole(IkHeuristic& h, const IkProblem& problem);
// Straightens a chain whose goal is too far, by the share that approach() returned.
void straighten(IkHeuristic& h, float beyond);

// FABRIK's first half: from the tips inwards, moves each node's point to where the bones on it have their lengths.
void reach_backward(IkHeuristic& h);
// FABRIK's second half: from the root outwards, turns each node, within its limit, to where its parts are wanted.
void reach_forward(IkHeuristic& h);
// The second half for points alone: no joint turns.
void reach_forward_by_points(IkHeuristic& h);
// Turns the joints of a plain chain to its points. Exact but under uneven scale.
void turn_to_points(IkHeuristic& h);
// Takes one step of Newton's method on the points of a chain: all bones turn towards one direction, so far that the tip
// comes to its goal. Quick for chains that are nearly straight, at which FABRIK and CCD are slow.
void pull(IkHeuristic& h);
// CCD: from the tips inwards, turns each joint so that its tips are nearest to their goals; stiff joints turn less.
void descend_once(IkHeuristic& h);

}  // namespace marrow
