// What FABRIK and CCD keep beside the tree: where points are to go, and what goals count in moving them.
#pragma once

#include "ik/tree.h"

namespace marrow {

// What a goal asks for.
struct IkAim {
  const IkNode* tip;
  f32x4 goal;             // the position to come to; out of reach: the nearest that is not
  WideRotation rotation;  // the one in the scene for the node that the tip hangs on
  float position;         // the weights, squared, relative to the greatest; a radian is as long as the tree
  float turn;
};

// The points of the tree: one for each node, and behind those one for each tip. What hangs on a node is a list.
struct IkPart {
  f32x4 at;                 // where the point is, or where it is wanted; scene
  f32x4 before;             // what an iteration changes, before it; CCD: of a tip its node's rotation in the scene
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
  float size_m = 0;                 // sum of all lengths
  float per_size = 0;               // 1 / size_m; 0 for no size
  bool free = true;                 // neither limits nor stiffness
  bool chain = false;               // one tip, with a position to reach
  bool plain = false;               // nothing but that: points move alone, and joints turn when they are there
  WideRotation turned = no_turn();  // how a plain chain has turned as a whole; scene

  Span<IkPart> of_tips() const { return {tips, tree->tips.size}; }
  // Of a chain, which goes on from one part to the next: without the root; and without root and tip.
  Span<IkPart> below_root() const { return {parts.data + 1, parts.size - 1}; }
  Span<IkPart> between() const { return {parts.data + 1, parts.size - 2}; }
};

// The direction of v, so long; 0 if it has none. Root and quotient do not wait for each other.
inline f32x4 along(f32x4 v, float length) {
  const float squared = squared3(v);
  return v * (has_direction(squared) ? length * (sqrt(squared) * (1.0f / squared)) : 0.0f);
}

// Takes its memory, in which the tree's positions, lengths and weights are then.
IkHeuristic set_up(IkTree& tree, Memory& scratch);

// A sum of turns: quaternions that are not of unit length weigh as they are long.
struct TurnSum {
  void add(WideRotation q, float w);
  // The shortest that takes a direction to another; none if one of them is none.
  void add_arc(f32x4 from, f32x4 to, float w);
  // The one about a hinge that takes a direction nearest to another; of no hinge, the shortest.
  void add_arc_about(f32x4 hinge, f32x4 from, f32x4 to, float w);
  WideRotation turn() const;  // not of unit length

  f32x4 sum = splat(0.0f);
  f32x4 across = splat(0.0f);  // about what to turn if the turns cancel each other
  float weight = 0;
};

// The inverse of the linear part of a frame.
struct InverseAxes {
  explicit InverseAxes(const f32x4 (&axis)[3]);
  // Of the length that it has, but for a factor above 0: not to wait for a division.
  f32x4 direction(f32x4 v) const { return products(cofactor, v) * sign; }
  f32x4 operator*(f32x4 v) const { return direction(v) * scale; }
  f32x4 cofactor[3];
  float sign, scale;
  bool exists;
};

// `share` of the turn q, of any length, the shorter way round; q itself if that is all of it.
WideRotation part_of(WideRotation any, float share);
float total_length(const IkHeuristic& h);
// Positions and lengths of all parts, from the frames.
void update_parts(IkHeuristic& h);
// And frames, from the rotations, before that.
void update(IkHeuristic& h);

// Of a chain with one end, before it moves: stretches bones, and puts a goal that is out of reach into reach. Returns
// by how much the goal is beyond the chain: 0 not at all, 1 so far that the chain shall be straight.
float approach(IkHeuristic& h, const IkOptions& options);
// Then, before the first iteration: turns the whole towards the goal, and wants joints that are on a line to it off
// that.
void set_out(IkHeuristic& h);
// Turns the chain about the line from its top to its end until it bends towards the pole.
void face_pole(IkHeuristic& h, const IkProblem& problem);
// Of a chain whose goal is beyond it.
void straighten(IkHeuristic& h, float beyond);

// FABRIK's first half: from the ends inwards, each joint is wanted where bones have their lengths.
void reach_backward(IkHeuristic& h);
// Its second half: from the top outwards, joints turn, within their limits, to where their parts are wanted.
void reach_forward(IkHeuristic& h);
// The same for the points of a plain chain: no joint turns.
void reach_forward_by_points(IkHeuristic& h);
// Then they do. Exact but for scales that are not the same in all directions.
void turn_to_points(IkHeuristic& h);
// One step of Newton's method on the points of a chain: all bones are bent towards one direction, each by as much as it
// is across it, so that the end comes to its goal. What FABRIK and CCD are slow at, a chain that is nearly straight,
// this does at once.
void pull(IkHeuristic& h);
// CCD: from the ends inwards, each joint turns to where the ends are nearest to their goals, but as it is stiff.
void descend_once(IkHeuristic& h);

}  // namespace marrow
