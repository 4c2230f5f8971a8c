// The iteration that FABRIK and CCD share, and the sums of turns in both.
#include "ik/heuristic.h"

#include "core/zone.h"
#include "marrow/block.h"

namespace marrow {
namespace {

void hang(IkPart& part) {
  if (part.on == nullptr) return;
  part.next = part.on->first;
  part.on->first = &part;
  part.on->weight += part.weight;
}

// Sets goals and weights, and links what hangs on each node; from the tips inwards.
void set_aims(IkHeuristic& h) {
  float greatest = 0;
  for (const IkNode& tip : h.tree->tips)
    greatest = greater(greatest, greater(tip.goal->position_weight, tip.goal->rotation_weight * h.per_size));
  const float scale = greatest > 0 ? 1.0f / greatest : 0.0f;
  for (IkPart& part : h.of_tips()) {
    IkAim& aim = *part.aim;
    const IkNode& tip = *aim.tip;
    const float position = tip.goal->position_weight * scale, turn = tip.goal->rotation_weight * h.per_size * scale;
    aim.goal = load_wide(tip.goal->position);
    aim.rotation = normalised(WideRotation{load(tip.goal->rotation)}) * conjugate(tip.above_turned);
    part.weight = aim.position = position * position;
    aim.turn = turn * turn;
    hang(part);
  }
  for (IkPart* node = h.tips; node-- != h.parts.data;) hang(*node);
  for (IkPart& part : h.parts)
    if (part.on != nullptr && part.on->weight > 0) part.share = part.weight / part.on->weight;
  for (const IkNode& node : h.tree->nodes) h.free = h.free && node.limit == nullptr && node.ease_root == 1.0f;
}

float error_of(const IkHeuristic& h) {
  float sum = 0;
  for (const IkPart& tip : h.of_tips()) sum = with_error(sum, *tip.aim->tip, tip.aim->goal - tip.at);
  return sqrt(sum);
}

// The parts whose state an iteration changes: in a plain chain the points, else the rotations of the nodes.
Span<IkPart> changing(const IkHeuristic& h) {
  return {h.parts.data, h.plain ? h.parts.size : h.tree->nodes.size};
}
f32x4 next_state(const IkPart& part, bool plain, const IkNode*& node) {
  return plain ? part.at : node++->rotation.v;
}

void keep_pose(IkHeuristic& h) {
  const bool plain = h.plain;
  const IkNode* node = h.tree->nodes.data;
  for (IkPart& part : changing(h)) part.before = next_state(part, plain, node);
}

// Whether the last iteration changed next to nothing.
bool at_rest(const IkHeuristic& h) {
  const bool plain = h.plain;
  const float scale = plain ? h.per_size : 1.0f;
  const IkNode* node = h.tree->nodes.data;
  for (const IkPart& part : changing(h)) {
    const f32x4 d = (part.before - next_state(part, plain, node)) * scale;
    if (dot4(d, d) > 1e-13f) return false;
  }
  return true;
}

void iterate_once(IkHeuristic& h, const IkProblem& problem, IkMethod method) {
  if (method == IkMethod::ccd) {
    descend_once(h);
    if (h.chain && h.free) {
      pull(h);
      reach_forward(h);
    }
  } else {
    for (IkPart& tip : h.of_tips()) tip.at = tip.aim->goal;
    reach_backward(h);
    if (h.chain) {
      reach_forward_by_points(h);
      pull(h);
    }
    if (!h.plain) reach_forward(h);
    if (!h.free) descend_once(h);  // what limits keep from turning, others make up for
  }
  if (h.chain && !h.free && problem.pole_weight > 0) face_pole(h, problem);
}

// Takes back all but a share of the last iteration.
void take_share_of_points(IkHeuristic& h, float share) {
  for (IkPart& part : h.parts) part.at = part.before + (part.at - part.before) * share;
}
void take_share_of_turns(IkHeuristic& h, float share) {
  const IkPart* part = h.parts.data;
  for (IkNode& node : h.tree->nodes) {
    const WideRotation before = {part++->before};
    set_turned(node, before * part_of(conjugate(before) * node.rotation, share));
  }
  update(h);
}

// Takes only the share of the last iteration that was needed, so that the result does not jump where one iteration more
// or less is enough: all of it if the error is just within the tolerance, none if it was before.
void stop_smoothly(IkHeuristic& h, float was, float error, float tolerance, bool first) {
  const float before = was - tolerance, after = 0.25f * (tolerance - error);
  if (!(before > 0 && after > 0)) return;
  const float share = before / (before + after);
  if (h.plain) {
    take_share_of_points(h, share);
    if (first) h.turned = part_of(h.turned, share);
  } else {
    take_share_of_turns(h, share);
  }
}

// Iterates until the aims are reached, nothing moves, or iterations are over.
void iterate(IkHeuristic& h, const IkProblem& problem, const IkOptions& options, IkReport& report) {
  float error = error_of(h);
  report.why = IkStop::reached;
  while (error > options.tolerance_m) {
    report.why = IkStop::iterations;
    if (report.iterations >= options.max_iterations) return;
    const float was = error;
    keep_pose(h);
    if (h.chain && report.iterations == 0) {
      set_out(h);
      if (options.method == IkMethod::ccd) reach_forward(h);
    }
    iterate_once(h, problem, options.method);
    ++report.iterations;
    error = error_of(h);
    report.why = error <= options.tolerance_m ? IkStop::reached : IkStop::stalled;
    if (report.why == IkStop::reached) stop_smoothly(h, was, error, options.tolerance_m, report.iterations == 1);
    if (at_rest(h)) return;
  }
}

}  // namespace

void count_heuristic(const Skeleton&, const IkProblem& problem, Memory& count) {
  count.take<IkPart>(problem.joints.size + problem.goals.size);
  count.take<IkAim>(problem.goals.size);
}

IkHeuristic set_up(IkTree& tree, Memory& scratch) {
  IkHeuristic h;
  h.tree = &tree;
  h.parts = scratch.take<IkPart>(tree.nodes.size + tree.tips.size);
  h.tips = h.parts.data + tree.nodes.size;
  h.aims = scratch.take<IkAim>(tree.tips.size).data;
  const IkNode* node = tree.nodes.data;
  for (IkPart& part : h.parts) {
    part = IkPart{};
    part.bone = &node->above.origin;
    if (node++->parent != kNoJoint) part.on = h.parts.data + node[-1].parent;
  }
  for (std::size_t i = 0; i < tree.tips.size; ++i) {
    h.tips[i].aim = h.aims + i;
    h.aims[i].tip = &tree.tips[i];
  }
  update_parts(h);
  h.size_m = total_length(h);
  h.per_size = h.size_m > 0 && h.size_m < 1e15f ? 1.0f / h.size_m : 0.0f;
  set_aims(h);
  h.chain = tree.tips.size == 1 && h.aims[0].position > 0 && h.per_size > 0;
  return h;
}

void solve_heuristic(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report) {
  const IkProblem& problem = call.problem;
  const IkOptions& options = call.options;
  IkHeuristic h = set_up(tree, scratch);
  const float beyond = h.chain ? approach(h, options) : 0.0f;
  if (h.per_size > 0) {
    h.plain = h.chain && h.free && h.aims[0].turn == 0 && options.method == IkMethod::fabrik;
    iterate(h, problem, options, report);
    if (h.plain) {
      h.plain = false;
      if (report.iterations > 0) turn_to_points(h);
      h.turned = no_turn();  // from now on the frames have it
      // Under uneven scale the lengths of bones depend on how joints are turned; iterate on with the new ones.
      if (report.why == IkStop::reached && error_of(h) > 1.1f * options.tolerance_m)
        iterate(h, problem, options, report);
    }
  }
  if (h.chain && h.free && problem.pole_weight > 0) face_pole(h, problem);
  if (beyond > 0) straighten(h, beyond);
  report.error_m = total_error(tree);
  if (report.why == IkStop::reached && report.error_m > 1.1f * options.tolerance_m) report.why = IkStop::stalled;
}

Status solve_ik_chain(const Pose& pose, const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                      IkReport* report) {
  MARROW_ZONE;
  MARROW_REQUIRE(options.method <= IkMethod::ccd);
  MARROW_REQUIRE_GOOD(solve_ik_by(solve_heuristic, count_heuristic, {pose, problem, options}, scratch, report));
  return Status::ok;
}

void TurnSum::add(WideRotation q, float w) {
  sum = sum + q.v * (dot4(sum, q.v) < 0 ? -w : w);
  weight += w;
}

void TurnSum::add_arc(f32x4 from, f32x4 to, float w) {
  const f32x4 a = along(from, 1.0f), b = along(to, 1.0f);
  if (!(squared3(a) > 0) || !(squared3(b) > 0)) return;
  const f32x4 both = a + b;
  add(quaternion(cross3(a, b), 0.5f * squared3(both)), w);
  if (!(squared3(across) > 0)) across = any_across3(a);
}

void TurnSum::add_arc_about(f32x4 hinge, f32x4 from, f32x4 to, float w) {
  add_arc(across3(from, hinge), across3(to, hinge), w);
  if (squared3(hinge) > 0) across = hinge;
}

WideRotation TurnSum::turn() const {
  if (dot4(sum, sum) > 1e-8f * weight * weight) return {sum};
  return weight > 0 ? WideRotation{across} : no_turn();
}

InverseAxes::InverseAxes(const f32x4 (&axis)[3])
    : cofactor{cross3(axis[1], axis[2]), cross3(axis[2], axis[0]), cross3(axis[0], axis[1])} {
  const float volume = dot3(axis[0], cofactor[0]), size = absolute(volume);
  exists = size > 1e-30f && size < 1e30f;
  sign = volume < 0 ? -1.0f : 1.0f;
  scale = exists ? 1.0f / size : 0.0f;
}

WideRotation part_of(WideRotation any, float share) {
  if (share == 1.0f) return any;
  const WideRotation q = normalised(any);
  return share_of(WideRotation{w_lane(q) < 0 ? q.v * -1.0f : q.v}, share);
}

float total_length(const IkHeuristic& h) {
  float sum = 0;
  for (const IkPart& part : h.parts) sum += part.length;
  return sum;
}

void update(IkHeuristic& h) {
  update_frames(*h.tree);
  update_parts(h);
}

void update_parts(IkHeuristic& h) {
  const IkNode* node = h.tree->nodes.data;
  for (IkPart& part : h.parts) {
    part.at = node++->frame.origin;
    part.length = part.on == nullptr ? 0.0f : length3(part.at - part.on->at);
  }
}

}  // namespace marrow
