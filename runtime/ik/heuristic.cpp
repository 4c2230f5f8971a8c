// The iteration that FABRIK and CCD share, and the sums of turns that joints make in both.
#include "ik/heuristic.h"

#include "core/mark.h"
#include "marrow/block.h"

namespace marrow {
namespace {

void add_part(IkHeuristic& h, std::size_t part, std::uint16_t node, float weight) {
  IkPart& p = h.parts[part];
  p.next = h.parts[node].first;
  h.parts[node].first = static_cast<std::uint16_t>(part);
  p.weight = weight;
  h.parts[node].weight += weight;
}

// Goals and their weights.
void set_aims(IkHeuristic& h) {
  const IkTree& tree = *h.tree;
  float greatest = 0;
  for (const IkEnd& end : tree.ends)
    greatest = greater(greatest, greater(end.goal->position_weight, end.goal->rotation_weight * h.per_size));
  const float scale = greatest > 0 ? 1.0f / greatest : 0.0f;
  for (std::size_t k = 0; k < tree.ends.size; ++k) {
    const IkEnd& end = tree.ends[k];
    IkAim& aim = h.aims[k];
    const float position = end.goal->position_weight * scale, turn = end.goal->rotation_weight * h.per_size * scale;
    aim.goal = load_wide(end.goal->position);
    aim.rotation = normalised(WideRotation{load(end.goal->rotation)}) * conjugate(end.rotation);
    aim.position = position * position;
    aim.turn = turn * turn;
  }
}

// What hangs on what, with what weight: from the ends inwards.
void set_shares(IkHeuristic& h) {
  const IkTree& tree = *h.tree;
  const std::size_t nodes = tree.nodes.size;
  for (std::size_t k = 0; k < tree.ends.size; ++k) add_part(h, nodes + k, tree.ends[k].node, h.aims[k].position);
  for (std::size_t i = nodes; i-- > 0;)
    if (tree.nodes[i].parent != kNoParent) add_part(h, i, tree.nodes[i].parent, h.parts[i].weight);
  for (std::size_t i = 0; i < nodes; ++i) {
    const IkPart& node = h.parts[i];
    for (std::uint16_t c = node.first; c != kNoPart; c = h.parts[c].next)
      h.parts[c].share = node.weight > 0 ? h.parts[c].weight / node.weight : 0.0f;
    h.free = h.free && tree.nodes[i].limit == nullptr && tree.nodes[i].ease_root == 1.0f;
  }
}

float error_of(const IkHeuristic& h) {
  float sum = 0;
  for (std::size_t k = 0; k < h.tree->ends.size; ++k)
    sum = with_error(sum, *h.tree, h.tree->ends[k], h.aims[k].goal - h.end(k).at);
  return sqrt(sum);
}

void keep_pose(IkHeuristic& h) {
  if (h.plain) {
    for (IkPart& part : h.points()) part.was = part.at;
  } else {
    for (std::size_t i = 0; i < h.tree->nodes.size; ++i) h.parts[i].before = h.tree->nodes[i].rotation;
  }
}

bool points_rest(const IkHeuristic& h) {
  for (const IkPart& part : h.points()) {
    const f32x4 d = (part.at - part.was) * h.per_size;
    if (squared3(d) > 1e-13f) return false;
  }
  return true;
}

bool joints_rest(const IkHeuristic& h) {
  for (std::size_t i = 0; i < h.tree->nodes.size; ++i) {
    const f32x4 d = h.parts[i].before.v - h.tree->nodes[i].rotation.v;
    if (dot4(d, d) > 1e-13f) return false;
  }
  return true;
}

// Whether the last iteration moved nothing.
bool at_rest(const IkHeuristic& h) {
  return h.plain ? points_rest(h) : joints_rest(h);
}

void iterate_once(IkHeuristic& h, const IkProblem& problem, IkMethod method) {
  if (method == IkMethod::ccd) {
    descend_once(h);
    if (h.chain && h.free) {
      pull(h);
      reach_forward(h);
    }
  } else {
    for (std::size_t k = 0; k < h.tree->ends.size; ++k) h.end(k).at = h.aims[k].goal;
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

// Of the last iteration only a share.
void take_share_of_points(IkHeuristic& h, float share) {
  for (IkPart& part : h.points()) part.at = part.was + (part.at - part.was) * share;
}
void take_share_of_turns(IkHeuristic& h, float share) {
  for (std::size_t i = 0; i < h.tree->nodes.size; ++i) {
    IkNode& node = h.tree->nodes[i];
    set_turned(node, h.parts[i].before * part_of(conjugate(h.parts[i].before) * node.rotation, share));
  }
  update(h);
}

// The last iteration counts by as much as it was needed, so that the result does not jump where one more, or one less,
// is enough: all of it if the error is just within the tolerance, nothing if it was before.
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

// Until the goals as they are in reach are reached, nothing moves, or iterations are over.
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
  h.parts = scratch.take<IkPart>(tree.nodes.size + tree.ends.size).data;
  h.ends = h.parts + tree.nodes.size;
  h.aims = scratch.take<IkAim>(tree.ends.size).data;
  for (std::size_t i = 0; i < tree.nodes.size + tree.ends.size; ++i) h.parts[i] = IkPart{};
  update_parts(h);
  for (std::size_t i = 0; i < tree.nodes.size + tree.ends.size; ++i) h.size_m += h.parts[i].length;
  h.per_size = h.size_m > 0 && h.size_m < 1e15f ? 1.0f / h.size_m : 0.0f;
  set_aims(h);
  set_shares(h);
  h.chain = tree.ends.size == 1 && h.aims[0].position > 0 && h.per_size > 0;
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
      h.turned = no_turn();  // the frames have it
      // Lengths that depend on how joints are turned, by scales that are not the same in all directions.
      if (report.why == IkStop::reached && error_of(h) > 1.1f * options.tolerance_m)
        iterate(h, problem, options, report);
    }
  }
  if (h.chain && h.free && problem.pole_weight > 0) face_pole(h, problem);
  if (beyond > 0) straighten(h, beyond);
  report.error_m = total_error(tree);
  if (report.why == IkStop::reached && report.error_m > 1.1f * options.tolerance_m) report.why = IkStop::stalled;
}

Status solve_ik_chain(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                      const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch, IkReport* report) {
  MARROW_MARK;
  MARROW_REQUIRE(options.method <= IkMethod::ccd);
  MARROW_REQUIRE_GOOD(solve_ik_by(solve_heuristic, count_heuristic,
                                  {{skeleton, local, scene_from_joint}, problem, options}, scratch, report));
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

void update(IkHeuristic& h) {
  update_frames(*h.tree);
  update_parts(h);
}

void update_parts(IkHeuristic& h) {
  const IkTree& tree = *h.tree;
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    IkPart& part = h.parts[i];
    part.at = tree.nodes[i].frame.origin;
    const std::uint16_t parent = tree.nodes[i].parent;
    part.length = parent == kNoParent ? 0.0f : length3(part.at - h.parts[parent].at);
  }
  for (std::size_t k = 0; k < tree.ends.size; ++k) {
    const IkEnd& end = tree.ends[k];
    IkPart& part = h.end(k);
    part.at = transform(tree.nodes[end.node].frame, end.point);
    part.length = length3(part.at - h.parts[end.node].at);
  }
}

}  // namespace marrow
