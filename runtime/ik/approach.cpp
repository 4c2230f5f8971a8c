// What FABRIK and CCD do for chains with one goal besides: set out, stretch, face a pole, straighten.
#include <algorithm>

#include "ik/heuristic.h"

namespace marrow {
namespace {

// Shares of a chain's length.
constexpr float kNearlyStraight = 5e-4f;  // a goal this far short of the whole length leaves the chain nearly straight
constexpr float kNearlyALine = 0.1f;      // joints this far off a line are nearly on it

float smooth_step(float x) {
  const float u = x <= 0 ? 0.0f : x < 1 ? x : 1.0f;
  return u * u * (3.0f - 2.0f * u);
}

// The shortest turn from one direction to another; if they are nearly opposite, half a turn about `axis` and then the
// little that is left.
WideRotation arc(f32x4 from, f32x4 to, f32x4 axis) {
  const f32x4 a = unit3_or(from, splat(0.0f)), b = unit3_or(to, a);
  if (squared3(a + b) > 1e-4f || !(squared3(a) > 0)) return shortest_arc(a, b);
  return shortest_arc(a * -1.0f, b) * WideRotation{unit3_or(across3(axis, a), any_across3(a))};
}

// Turns the first node, and the chain with it, by the part `share` of that.
void turn_all(IkHeuristic& h, f32x4 from, f32x4 to, f32x4 axis, float share) {
  IkNode& node = h.tree->nodes[0];
  if (h.plain) {  // the points alone
    const WideRotation by = part_of(arc(from, to, axis), share);
    h.turned = by * h.turned;
    const f32x4 root = h.parts[0].at;
    for (IkPart& part : h.below_root()) part.at = root + rotate(by, part.at - root);
    return;
  }
  const InverseAxes inverse(node.frame.axis);
  if (!inverse.exists) return;
  const float ease = share * node.ease_root * node.ease_root;
  set_turned(node, node.rotation * part_of(arc(inverse * from, inverse * to, inverse * axis), ease));
  update(h);
}

// Makes the bones longer if the distance is more than `most`, shorter if it is less than `least`. Only in the first
// start, as later ones find the bones stretched.
void stretch(IkHeuristic& h, float distance, float least, float most, float limit) {
  IkTree& tree = *h.tree;
  float factor = 1;
  if (distance > most) factor = std::min(distance / most, limit);
  if (distance < least) factor = std::max(distance / least, 1.0f / limit);
  if (factor == 1 || tree.stretch != 1) return;
  tree.stretch = factor;
  for (std::size_t i = 1; i < tree.nodes.size; ++i) tree.nodes[i].above.origin = tree.nodes[i].above.origin * factor;
  IkNode& tip = tree.tips[0];
  const f32x4 bone = tip.above.origin - turn(tip.above, load_wide(tip.goal->offset));  // without the offset
  tip.above.origin = tip.above.origin + bone * (factor - 1.0f);
  tip.parent_from_frame.origin = tip.above.origin;
  update(h);
}

// A distance from least + margin to most - margin stays as it is. Beyond, it changes ever more slowly, without a jump
// of slope, and stays half a margin away from `least` and `most`.
float into_reach(float distance, float least, float most, float margin) {
  const float half = 0.5f * margin, over = distance - (most - margin), under = least + margin - distance;
  if (over > 0) return most - half - half * half / (over + half);
  if (least > 0 && under > 0) return least + half + half * half / (under + half);
  return distance;
}

// The direction for what has none.
f32x4 up() {
  return lanes(0.0f, 1.0f, 0.0f, 0.0f);
}

// A direction across the first bone that is fixed to the first joint: the chain's own side.
f32x4 own_side(const IkHeuristic& h) {
  const IkTree& tree = *h.tree;
  const f32x4 bone = *h.parts[1].bone;
  return rotate(h.turned, turn(tree.nodes[0].frame, any_across3(unit3_or(bone, up()))));
}

// The side of a line through the root on which the joints are, each counted by its distance, and how far the farthest
// of them is. own: a little of the chain's own side is added, which decides where all joints are on the line.
f32x4 side_of_joints(const IkHeuristic& h, f32x4 line, bool own, float& farthest) {
  f32x4 sum = own_side(h) * (own ? h.size_m * 1e-3f : 0.0f);
  farthest = 0;
  const f32x4 root = h.parts[0].at;
  for (const IkPart& part : h.between()) {
    const f32x4 off = across3(part.at - root, line);
    farthest = std::max(farthest, length3(off));
    sum = sum + off;
  }
  return unit3_or(across3(sum, line), splat(0.0f));
}

// The direction from the root to the goal; to the tip, if the goal is at the root.
f32x4 line_to_goal(const IkHeuristic& h) {
  const f32x4 root = h.parts[0].at;
  return unit3_or(h.aims[0].goal - root, unit3_or(h.tips[0].at - root, up()));
}

// Bends a chain that lies nearly on the line to its goal, for which joints have no side to go to, or go slowly. The
// nearer they are to the line, the more they are moved onto an arc from root to goal: on their side of the line, else
// on the chain's own side.
void bow(IkHeuristic& h) {
  const f32x4 root = h.parts[0].at, line = line_to_goal(h);
  float off;
  const f32x4 aside = side_of_joints(h, line, true, off);
  const float straight = 1.0f - off * h.per_size * (1.0f / kNearlyALine);
  const float slack = 1.0f - length3(h.aims[0].goal - root) * h.per_size;
  if (!(straight > 0 && slack > 0)) return;
  const float share = straight * straight;
  // The sag of a parabola about as long as the chain, and a little more where that would be flat.
  const float sag = sqrt(0.375f * slack * (1.0f - slack)) + 0.02f * slack;
  const f32x4 side = (squared3(aside) > 0 ? aside : any_across3(line)) * (4.0f * sag * h.size_m * share);
  float so_far = 0;
  for (IkPart& part : h.between()) {
    so_far += part.length * h.per_size;
    part.at = part.at - line * (slack * share * dot3(part.at - root, line)) + side * (so_far * (1.0f - so_far));
  }
}

// Turns the chain about the line from its root to its tip until its joints are on the wanted side; with less weight, to
// a side between. A wanted direction within 6 degrees of the line counts less and less.
void face(IkHeuristic& h, f32x4 wanted, bool own, float weight) {
  const f32x4 none = splat(0.0f), line = unit3_or(h.tips[0].at - h.parts[0].at, none), to = across3(wanted, line);
  float off;
  const f32x4 side = side_of_joints(h, line, own, off);
  if (!(squared3(line) > 0) || !(squared3(side) > 0)) return;
  const float share = weight * smooth_step(10.0f * length3(to));
  turn_all(h, side, side * (1.0f - share) + unit3_or(to, none) * share, line, 1.0f);
}

}  // namespace

float approach(IkHeuristic& h, const IkOptions& options) {
  IkAim& aim = h.aims[0];
  const f32x4 root = h.parts[0].at;
  const float distance = length3(aim.goal - root);
  const float beyond = h.free ? smooth_step(0.5f + (distance * h.per_size - 1.0f) * (0.5f / kNearlyStraight)) : 0.0f;
  float longest = 0;
  for (const IkPart& part : h.parts) longest = std::max(longest, part.length);
  const float folded = std::max(2.0f * longest * h.per_size - 1.0f,
                                0.0f);  // the nearest that the tip can come to the root, as a share of the size
  stretch(h, distance, folded * h.size_m, h.size_m, options.stretch);
  h.size_m = total_length(h);
  h.per_size = 1.0f / h.size_m;
  const f32x4 line = line_to_goal(h);
  const float near = into_reach(distance, folded * h.size_m, h.size_m, kNearlyStraight * h.size_m);
  aim.goal = root + line * near;
  return beyond;
}

// Where the goal is opposite to the tip, the shortest turn puts the bend on one side for one goal and on another for
// its neighbour. So within 29 degrees of there the bend is kept, the more the nearer, on the side to which half a turn
// in the chain's own plane takes it. The bend still jumps at goals in two directions; neither is in that plane or
// perpendicular to it.
void set_out(IkHeuristic& h) {
  const f32x4 root = h.parts[0].at, from = h.tips[0].at - root, to = h.aims[0].goal - root;
  const f32x4 line = unit3_or(from, up()), apart = line + unit3_or(to, line);  // how far the goal is from opposite
  const float opposite = smooth_step(1.0f - 4.0f * squared3(apart)), keeps = h.free ? opposite : 0.0f;
  const float near = (4.0f + 4.0f * keeps) * (length3(from) * h.per_size) * (length3(to) * h.per_size);
  float off;
  f32x4 side = splat(0.0f);
  if (opposite > 0) side = side_of_joints(h, line, true, off);
  turn_all(h, from, to, cross3(line, side), std::min(near, 1.0f));
  const float weight = keeps * smooth_step(2.0f * near - 1.0f);
  if (weight > 0) face(h, apart * 2.0f - side, true, weight);
  bow(h);
}

void face_pole(IkHeuristic& h, const IkProblem& problem) {
  const f32x4 towards = load_wide(problem.pole) - h.parts[0].at;
  face(h, unit3_or(towards, splat(0.0f)), false, problem.pole_weight);
}

void straighten(IkHeuristic& h, float beyond) {
  const f32x4 root = h.parts[0].at, line = unit3_or(h.aims[0].goal - root, splat(0.0f));
  float so_far = 0;
  for (IkPart& part : h.below_root()) {
    so_far += part.length;
    part.at = part.at + (root + line * so_far - part.at) * beyond;
  }
  reach_forward(h);
}

}  // namespace marrow
