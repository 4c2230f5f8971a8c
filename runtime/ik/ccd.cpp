// Cyclic coordinate descent (Wang and Chen 1991) on a tree of joints.
#include "ik/heuristic.h"

namespace marrow {
namespace {

// What turns node i, of its own axes, so that the ends that it moves come nearest to their goals.
WideRotation best_turn(const IkHeuristic& h, std::size_t i, const InverseAxes& inverse) {
  const IkNode& node = h.tree->nodes[i];
  const f32x4 origin = h.parts[i].at;
  TurnSum turns;
  for (std::size_t k = 0; k < h.tree->ends.size; ++k) {
    const IkPart& end = h.end(k);
    if (end.first != i) continue;
    const IkAim& aim = h.aims[k];
    const f32x4 from = end.at - origin, to = aim.goal - origin;
    const float lever = length3(from) * h.per_size * (length3(to) * h.per_size);
    turns.add_arc_about(node.hinge, inverse * from, inverse * to, aim.position * lever);
    if (aim.turn > 0) turns.add(conjugate(node.turned) * aim.rotation * conjugate(end.before) * node.turned, aim.turn);
  }
  return turns.turn();
}

// Takes the ends that node i moves along as it turns by `by`; then they hang on the node above.
void carry_ends(IkHeuristic& h, std::size_t i, const InverseAxes& inverse, WideRotation by) {
  const IkNode& node = h.tree->nodes[i];
  const f32x4 origin = h.parts[i].at;
  for (std::size_t k = 0; k < h.tree->ends.size; ++k) {
    IkPart& end = h.end(k);
    if (end.first != i) continue;
    end.first = node.parent;
    if (!inverse.exists) continue;
    end.at = origin + turn(node.frame, rotate(by, inverse * (end.at - origin)));
    if (h.tree->turns) end.before = node.turned * by * conjugate(node.turned) * end.before;
  }
}

}  // namespace

void descend_once(IkHeuristic& h) {
  IkTree& tree = *h.tree;
  for (std::size_t k = 0; k < tree.ends.size; ++k) {
    h.end(k).first = tree.ends[k].node;  // which node moves it now
    h.end(k).before = tree.nodes[tree.ends[k].node].turned;
  }
  for (std::size_t i = tree.nodes.size; i-- > 0;) {
    IkNode& node = tree.nodes[i];
    const InverseAxes inverse(node.frame.axis);
    const WideRotation was = node.rotation;
    if (inverse.exists) set_turned(node, was * part_of(best_turn(h, i, inverse), node.ease_root * node.ease_root));
    carry_ends(h, i, inverse, conjugate(was) * node.rotation);
  }
  update(h);
}

}  // namespace marrow
