// Cyclic coordinate descent (Wang and Chen 1991) on a tree of joints.
#include "ik/heuristic.h"

namespace marrow {
namespace {

// The turn of a node, in its own axes, that brings the tips it moves nearest to their goals.
WideRotation best_turn(const IkHeuristic& h, const IkNode& node, const IkPart& part, const InverseAxes& inverse) {
  const f32x4 origin = part.at;
  TurnSum turns;
  for (const IkPart& tip : h.of_tips()) {
    if (tip.first != &part) continue;
    const IkAim& aim = *tip.aim;
    const f32x4 from = tip.at - origin, to = aim.goal - origin;
    const float lever = length3(from) * h.per_size * (length3(to) * h.per_size);
    turns.add_arc_about(node.hinge, inverse * from, inverse * to, aim.position * lever);
    if (aim.turn > 0)
      turns.add(conjugate(node.turned) * aim.rotation * conjugate(WideRotation{tip.before}) * node.turned, aim.turn);
  }
  return turns.turn();
}

// Moves the tips of a node that turns by `by`. From then on the node above moves them.
void carry_tips(IkHeuristic& h, const IkNode& node, const IkPart& part, const InverseAxes& inverse, WideRotation by) {
  const f32x4 origin = part.at;
  for (IkPart& tip : h.of_tips()) {
    if (tip.first != &part) continue;
    tip.first = part.on;
    if (!inverse.exists) continue;
    tip.at = origin + turn(node.frame, rotate(by, inverse * (tip.at - origin)));
    if (h.tree->turns) tip.before = (node.turned * by * conjugate(node.turned) * WideRotation{tip.before}).v;
  }
}

}  // namespace

void descend_once(IkHeuristic& h) {
  IkTree& tree = *h.tree;
  for (IkPart& tip : h.of_tips()) {
    tip.first = tip.on;
    tip.before = tree.nodes[tip.aim->tip->parent].turned.v;
  }
  IkNode* next = tree.nodes.end();
  for (IkPart* part = h.tips; part-- != h.parts.data;) {
    IkNode& node = *--next;
    const InverseAxes inverse(node.frame.axis);
    const WideRotation was = node.rotation;
    if (inverse.exists)
      set_turned(node, was * part_of(best_turn(h, node, *part, inverse), node.ease_root * node.ease_root));
    carry_tips(h, node, *part, inverse, conjugate(was) * node.rotation);
  }
  update(h);
}

}  // namespace marrow
