// What chains with one goal have besides FABRIK and CCD: how they set out, reach, stretch, and face a pole.
#include <algorithm>

#include "ik/heuristic.h"
#include "math/rotation.h"

namespace marrow {
namespace {

constexpr float kNearlyStraight = 5e-4f;  // of its length, by which a chain is short of straight
constexpr float kNearlyALine = 0.1f;      // of its length, by which a chain's joints are off a line

float smooth_step(float x) {
  const float u = x <= 0 ? 0.0f : x < 1 ? x : 1.0f;
  return u * u * (3.0f - 2.0f * u);
}

// The shortest turn from one direction to another; if they are opposite, about `axis`.
Rotation arc(const Vector3& from, const Vector3& to, const Vector3& axis) {
  const Vector3 a = normalised_or(from, {}), b = normalised_or(to, a), sum = a + b;
  if (dot(sum, sum) > 3e-8f || dot(a, a) == 0) return shortest_arc(a, b);
  return quaternion(normalised_or(across(axis, a), any_across(a)), 0.0f);
}

// Turns the first node, and the chain with it, by `share` of that.
void turn_all(IkHeuristic& h, const Vector3& from, const Vector3& to, const Vector3& axis, float share) {
  IkNode& node = h.tree->nodes[0];
  if (h.plain) {  // by its points alone
    h.turned = part_of(arc(from, to, axis), share);
    for (std::size_t i = 1; i <= h.tree->nodes.size; ++i)
      h.parts[i].at = h.parts[0].at + rotate(h.turned, h.parts[i].at - h.parts[0].at);
    return;
  }
  const InverseAxes inverse(node.frame.axis);
  if (!inverse.exists) return;
  const float ease = share * node.ease_root * node.ease_root;
  set_turned(node, node.rotation * part_of(arc(inverse * from, inverse * to, inverse * axis), ease));
  update_frames(*h.tree);
  update_parts(h);
}

float total_length(const IkHeuristic& h) {
  float sum = 0;
  for (std::size_t i = 0; i <= h.tree->nodes.size; ++i) sum += h.parts[i].length;
  return sum;
}

// Makes bones longer if the distance is more than `most`, shorter if it is less than `least`.
void stretch(IkHeuristic& h, float distance, float least, float most, float limit) {
  IkTree& tree = *h.tree;
  float factor = 1;
  if (distance > most) factor = std::min(distance / most, limit);
  if (distance < least) factor = std::max(distance / least, 1.0f / limit);
  if (factor == 1) return;
  tree.stretch = factor;
  for (std::size_t i = 1; i < tree.nodes.size; ++i)
    tree.nodes[i].above.origin = tree.nodes[i].above.origin * splat(factor);
  tree.ends[0].point = tree.ends[0].point + tree.ends[0].bone * splat(factor - 1.0f);
  update_frames(tree);
  update_parts(h);
}

// From least + margin to most - margin what it is, and beyond, without a jump of slope, half as far again at most.
float into_reach(float distance, float least, float most, float margin) {
  const float half = 0.5f * margin, over = distance - (most - margin), under = least + margin - distance;
  if (over > 0) return most - half - half * half / (over + half);
  if (least > 0 && under > 0) return least + half + half * half / (under + half);
  return distance;
}

// A side of the chain that is fixed to its first joint, across the first bone: the same as it moves.
Vector3 own_side(const IkHeuristic& h) {
  const IkTree& tree = *h.tree;
  const f32x4 bone = tree.nodes.size > 1 ? tree.nodes[1].above.origin : tree.ends[0].point;
  const Vector3 side = any_across(normalised_or(to_vector3(bone), {0, 1, 0}));
  return to_vector3(turn(tree.nodes[0].frame, side));
}

// To which side of a line through the root the joints are, each by how far it is; and the farthest of them.
Vector3 side_of_joints(const IkHeuristic& h, const Vector3& line, float& farthest) {
  Vector3 sum;
  farthest = 0;
  for (std::size_t i = 1; i < h.tree->nodes.size; ++i) {
    const Vector3 off = across(h.parts[i].at - h.parts[0].at, line);
    farthest = std::max(farthest, length(off));
    sum = sum + off;
  }
  return sum;
}

// Joints of a chain that is all on the line to its goal have no side to go to, and those of one that is nearly so move
// aside slowly. So the nearer they are to it, the more of an arc from the root to the goal they are wanted on: on the
// side that they are on, else on the chain's own.
void bow(IkHeuristic& h) {
  const Vector3 root = h.parts[0].at, to = h.aims[0].goal - root;
  const Vector3 line = normalised_or(to, normalised_or(h.end(0).at - root, {0, 1, 0}));
  float off;
  const Vector3 sides = side_of_joints(h, line, off) * h.per_size + own_side(h) * 1e-3f;
  const float straight = 1.0f - off * h.per_size * (1.0f / kNearlyALine);
  const float slack = 1.0f - length(to) * h.per_size;
  if (!(straight > 0 && slack > 0)) return;
  const float share = straight * straight;
  // A parabola that is as long as the chain, nearly; and a little more where it would be flat.
  const float sag = sqrt(0.375f * slack * (1.0f - slack)) + 0.02f * slack;
  const Vector3 side = normalised_or(across(sides, line), any_across(line)) * (4.0f * sag * h.size_m * share);
  float so_far = 0;
  for (std::size_t i = 1; i < h.tree->nodes.size; ++i) {
    Vector3& at = h.parts[i].at;
    so_far += h.parts[i].length * h.per_size;
    at = at - line * (slack * share * dot(at - root, line)) + side * (so_far * (1.0f - so_far));
  }
}

}  // namespace

float approach(IkHeuristic& h, const IkOptions& options) {
  IkAim& aim = h.aims[0];
  IkPart& end = h.end(0);
  const Vector3 root = h.parts[0].at;
  const float distance = length(aim.goal - root);
  const float beyond = h.free ? smooth_step(0.5f + (distance * h.per_size - 1.0f) * (0.5f / kNearlyStraight)) : 0.0f;
  float longest = 0;
  for (std::size_t i = 0; i <= h.tree->nodes.size; ++i) longest = std::max(longest, h.parts[i].length);
  const float folded = std::max(2.0f * longest * h.per_size - 1.0f, 0.0f);  // of the size: as near as the end can come
  stretch(h, distance, folded * h.size_m, h.size_m, options.stretch);
  h.size_m = total_length(h);
  h.per_size = 1.0f / h.size_m;
  const Vector3 line = normalised_or(aim.goal - root, normalised_or(end.at - root, {0, 1, 0}));
  const float near = into_reach(distance, folded * h.size_m, h.size_m, kNearlyStraight * h.size_m);
  aim.goal = root + line * near;
  return beyond;
}

void set_out(IkHeuristic& h) {
  const Vector3 root = h.parts[0].at, from = h.end(0).at - root, to = h.aims[0].goal - root;
  const float near = 4.0f * (length(from) * h.per_size) * (length(to) * h.per_size);
  const Vector3 line = normalised_or(from, {0, 1, 0});
  float off;
  const Vector3 side = normalised_or(side_of_joints(h, line, off), own_side(h));
  turn_all(h, from, to, cross(line, side), std::min(near, 1.0f));
  bow(h);
}

void face_pole(IkHeuristic& h, const IkProblem& problem) {
  const Vector3 root = h.parts[0].at, to_pole = vector3(problem.pole) - root;
  const Vector3 line = normalised_or(h.end(0).at - root, {});
  float off;
  const Vector3 side = normalised_or(side_of_joints(h, line, off), {});
  if (dot(line, line) == 0 || dot(side, side) == 0) return;
  const Vector3 wanted = across(normalised_or(to_pole, {}), line);
  // Within 6 degrees of the line the pole has less and less to say.
  const float weight = problem.pole_weight * smooth_step(10.0f * length(wanted));
  turn_all(h, side, side * (1.0f - weight) + normalised_or(wanted, {}) * weight, line, 1.0f);
}

void straighten(IkHeuristic& h, float beyond) {
  const Vector3 root = h.parts[0].at, line = normalised_or(h.aims[0].goal - root, {});
  float so_far = 0;
  for (std::size_t i = 1; i <= h.tree->nodes.size; ++i) {
    so_far += h.parts[i].length;
    h.parts[i].at = h.parts[i].at + (root + line * so_far - h.parts[i].at) * beyond;
  }
  reach_forward(h);
}

}  // namespace marrow
