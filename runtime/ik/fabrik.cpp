// FABRIK (Aristidou and Lasenby 2011) on a tree of joints, and the Newton step on points that FABRIK and CCD end with.
#include "ik/heuristic.h"

namespace marrow {
namespace {

// From a tip back to its node: along the line between them, and, by the weight of the goal's rotation, as the goal
// would have the node turned.
f32x4 back_from_tip(const IkHeuristic& h, const IkPart& tip, f32x4 along_line) {
  const IkAim& aim = *tip.aim;
  if (aim.turn == 0) return along_line;
  const float length = tip.length, lever = length * h.per_size;
  const f32x4 turned = unit3_or(rotate(aim.rotation, *tip.bone), splat(0.0f)) * -length;
  return along_line + (turned - along_line) * (aim.turn / (aim.turn + aim.position * lever * lever));
}

// The turn that brings what hangs on a node to where it is wanted. above: the node's axes before they turn.
WideRotation forward_turn(const IkHeuristic& h, const IkNode& node, const IkPart* part, const Columns& above) {
  const InverseAxes inverse(above.axis);
  const f32x4 hinge = rotate(node.rotation, node.hinge);
  TurnSum turns;
  for (; part != nullptr; part = part->next) {
    const float lever = part->length * h.per_size;
    turns.add_arc_about(hinge, rotate(node.rotation, *part->bone), inverse.direction(part->at - above.origin),
                        part->weight * lever * lever);
    const IkAim* const aim = part->aim;
    if (aim == nullptr || aim->turn == 0) continue;
    turns.add(conjugate(above_turned(*h.tree, node)) * aim->rotation * conjugate(node.rotation), aim->turn);
  }
  return turns.turn();
}

}  // namespace

void reach_forward_by_points(IkHeuristic& h) {
  f32x4 from = h.parts[0].at;
  for (IkPart& part : h.below_root()) {
    from = part.at = from + along(part.at - from, part.length);
  }
}

// If joint i's parent has turned by `turned` in model space, bone i has too. What it still lacks is found in the old
// frames, turned back: so no frame waits for the one above it.
void turn_to_points(IkHeuristic& h) {
  IkTree& tree = *h.tree;
  WideRotation turned = h.turned;
  const IkPart* part = h.parts.data;
  for (IkNode& node : tree.nodes) {
    const f32x4 at = part->at;
    const bool top = part++ == h.parts.data;
    TurnSum arc;
    arc.add_arc(turn(node.frame, *part->bone), rotate(conjugate(turned), part->at - at), 1.0f);
    const WideRotation by = normalised(arc.turn()), in_model = top ? turned * by : by;
    turned = turned * by;
    const InverseAxes inverse(node.frame.axis);
    const f32x4 axis = without_w(in_model.v);
    const f32x4 in_frame = along(inverse.direction(axis), inverse.sign * length3(axis));
    set_turned(node, node.rotation * quaternion(in_frame, w_lane(in_model)));
  }
  update(h);
}

void pull(IkHeuristic& h) {
  // The tip is at Σ length · d, with d the directions of the bones. If each becomes d + v, made a unit vector, the tip
  // moves by Σ length (I - d dᵀ) v, to first order in v.
  f32x4 axes[3] = {splat(0.0f), splat(0.0f), splat(0.0f)};
  f32x4 from = h.parts[0].at, before = from;
  for (const IkPart& part : h.below_root()) {
    const float length = part.length;
    const f32x4 d = along(part.at - before, 1.0f), w = d * length;
    before = part.at;
    axes[0] = axes[0] + (lanes(length, 0, 0, 0) - splat_lane<0>(w) * d);
    axes[1] = axes[1] + (lanes(0, length, 0, 0) - w * splat_lane<1>(d));
    axes[2] = axes[2] + (lanes(0, 0, length, 0) - w * splat_lane<2>(d));
  }
  axes[1] = with_z(axes[1], first_lane(splat_lane<1>(axes[2])));  // symmetric to the last bit
  const float least = 1e-4f * h.size_m, s = h.per_size;           // a straight chain cannot be moved along itself
  axes[0] = (axes[0] + lanes(least, 0, 0, 0)) * s;
  axes[1] = (axes[1] + lanes(0, least, 0, 0)) * s;
  axes[2] = (axes[2] + lanes(0, 0, least, 0)) * s;
  f32x4 v = InverseAxes(axes) * ((h.aims[0].goal - before) * s);
  v = v * (1.0f / sqrt(1.0f + squared3(v) * 1.2f));  // shorter than d, so that no bone turns round
  before = from;
  for (IkPart& part : h.below_root()) {
    const f32x4 d = along(part.at - before, 1.0f);
    before = part.at;
    from = part.at = from + along(d + v, part.length);
  }
}

void reach_backward(IkHeuristic& h) {
  for (IkPart* node = h.tips; node-- != h.parts.data;) {
    if (node->on == nullptr || node->weight == 0) continue;
    f32x4 wanted = splat(0.0f);
    for (const IkPart* part = node->first; part != nullptr; part = part->next) {
      f32x4 back = along(node->at - part->at, part->length);
      if (part->aim != nullptr) back = back_from_tip(h, *part, back);
      wanted = wanted + (part->at + back) * part->share;
    }
    node->at = wanted;
  }
}

void reach_forward(IkHeuristic& h) {
  IkTree& tree = *h.tree;
  const IkPart* part = h.parts.data;
  for (IkNode& node : tree.nodes) {
    Columns above = node.above;
    if (node.parent != kNoJoint) multiply(tree.nodes[node.parent].frame, above, above);
    const WideRotation by = forward_turn(h, node, (part++)->first, above);
    const float ease = node.ease_root * node.ease_root;
    set_turned(node, part_of(by, ease) * node.rotation);
    turn_axes(above, node.rotation, node.frame.axis);
    node.frame.origin = above.origin;
    if (tree.turns) node.turned = above_turned(tree, node) * node.rotation;
  }
  update_tips(tree);
  update_parts(h);
}

}  // namespace marrow
