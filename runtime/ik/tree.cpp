#include "ik/tree.h"

#include "core/check.h"
#include "limits/joint_limit.h"
#include "marrow/local_to_model.h"
#include "math/joint.h"
#include "math/rotation.h"

namespace marrow {
namespace {

// parent_from_joint of a joint that does not turn.
Columns local_frame(Span<const SoaTransform> local, std::size_t joint) {
  const f32x4 s = wide_scale_of(local, joint);
  Columns f;
  set_axes(wide_rotation_of(local, joint), f.axis);
  f.axis[0] = f.axis[0] * splat_lane<0>(s);
  f.axis[1] = f.axis[1] * splat_lane<1>(s);
  f.axis[2] = f.axis[2] * splat_lane<2>(s);
  f.origin = wide_translation_of(local, joint);
  return f;
}

// Sets the node's parent: the nearest node above `joint`, that joint included. Extends `above` by all joints on the way
// there. At first `above` maps the node's axes to the space of `joint`; afterwards it maps them to the parent's frame,
// or to model space if there is no parent. Sets above_turned to the rotation on that way.
void set_above(const Pose& pose, const std::uint16_t* node_of, std::uint16_t joint, IkNode& node) {
  const Skeleton& skeleton = pose.skeleton;
  const Span<const SoaTransform> local = pose.local;
  std::uint16_t on = joint;
  while (on != kNoJoint && node_of[on] == kNoJoint) on = skeleton.parents[on];
  const bool top = on == kNoJoint;
  Columns& above = node.above;
  WideRotation turned = no_turn();
  std::uint16_t root = node.joint;
  for (std::uint16_t j = joint; j != on; j = skeleton.parents[j]) {
    if (!top) multiply(local_frame(local, j), above, above);
    turned = wide_rotation_of(local, j) * turned;
    root = j;
  }
  if (top) {
    node.parent = kNoJoint;
    multiply(columns(map_above(pose, node.joint)), above, above);
    turned = rotation_of(skeleton.model_from_root[root]) * turned;
  } else {
    node.parent = node_of[on];
    const f32x4 scale = wide_scale_of(local, on);
    for (f32x4& axis : above.axis) axis = axis * scale;
    above.origin = above.origin * scale;
  }
  node.above_turned = turned;
}

void set_node(const IkCall& call, std::size_t place, const std::uint16_t* node_of, IkNode& node) {
  const IkProblem& problem = call.problem;
  node.joint = problem.joints[place];
  node.place = static_cast<std::uint16_t>(place);
  node.goal = nullptr;
  node.ease_root = problem.stiffness.empty() ? 1.0f : sqrt(1.0f - problem.stiffness[place]);
  node.rotation = node.start = wide_rotation_of(call.pose.local, node.joint);
  node.limit = find_limit(problem.limits, node.joint);
  node.hinge = splat(0.0f);
  if (node.limit != nullptr && node.limit->kind == LimitKind::hinge)
    node.hinge = rotate({load(node.limit->joint_from_limit)}, lanes(1.0f, 0.0f, 0.0f, 0.0f));
  set_axes(no_turn(), node.above.axis);
  node.above.origin = wide_translation_of(call.pose.local, node.joint);
  set_above(call.pose, node_of, call.pose.skeleton.parents[node.joint], node);
  if (node.limit != nullptr && node.ease_root > 0) node.rotation = clamped(*node.limit, node.rotation);
}

void set_tip(const Pose& pose, const IkGoal& goal, const std::uint16_t* node_of, IkNode& tip) {
  tip.joint = goal.joint;
  tip.goal = &goal;
  set_axes(no_turn(), tip.above.axis);
  tip.above.origin = load_wide(goal.offset);
  set_above(pose, node_of, goal.joint, tip);
  tip.parent_from_frame = tip.above;
}

void set_translation(Span<SoaTransform> local, std::size_t joint, f32x4 to) {
  set_three_of_lane(&local[joint / 4].translation[0][joint % 4], to);
}

// Stretches a tree with one goal: scales the translations of all joints below its first node, down to the goal's joint.
void stretch_bones(const Pose& pose, const IkTree& tree, float factor) {
  for (std::uint16_t j = tree.tips[0].joint; j != tree.nodes[0].joint; j = pose.skeleton.parents[j])
    set_translation(pose.local, j, wide_translation_of(pose.local, j) * factor);
}

}  // namespace

IkTree place_tree(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch) {
  return {scratch.take<IkNode>(problem.joints.size + problem.goals.size),
          {},
          scratch.take<std::uint16_t>(skeleton.joint_count).data};
}

BadCall build_tree(const IkCall& call, IkTree& tree) {
  const Skeleton& skeleton = call.pose.skeleton;
  const IkProblem& problem = call.problem;
  constexpr std::uint16_t kMayTurn = 0xFFFE, kMoves = 0xFFFD;  // kMoves: may turn, and moves a goal
  std::uint16_t* const node_of = tree.node_of;
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) node_of[j] = kNoJoint;
  for (const std::uint16_t j : problem.joints) node_of[j] = kMayTurn;
  for (const IkGoal& goal : problem.goals) {
    bool moves = false;
    for (std::uint16_t j = goal.joint; j != kNoJoint; j = skeleton.parents[j]) {
      if (node_of[j] == kNoJoint) continue;
      node_of[j] = kMoves;
      moves = true;
    }
    MARROW_CHECK(moves && "each goal hangs on a joint that turns");
    tree.turns = tree.turns || goal.rotation_weight > 0;
  }
  std::uint16_t count = 0;
  for (std::size_t i = 0; i < problem.joints.size; ++i) {
    const std::uint16_t joint = problem.joints[i];
    if (node_of[joint] == kMayTurn) {
      node_of[joint] = kNoJoint;
      continue;
    }
    set_node(call, i, node_of, tree.nodes[count]);
    node_of[joint] = count++;
  }
  tree.nodes.size = count;
  tree.tips = {tree.nodes.end(), problem.goals.size};
  for (std::size_t i = 0; i < problem.goals.size; ++i) set_tip(call.pose, problem.goals[i], node_of, tree.tips[i]);
  update_frames(tree);
  f32x4 sum = splat(0.0f);
  for (const IkNode& node : tree.nodes) {
    sum = sum + node.frame.axis[0] + node.frame.axis[1] + node.frame.axis[2] + node.above_turned.v;
  }
  for (const IkNode& tip : tree.tips) sum = sum + tip.frame.origin + tip.above_turned.v;
  MARROW_CHECK(all_finite(sum) && "the pose and the goals");
  return {};
}

void begin_anew(IkTree& tree, Chance& chance, float size) {
  for (IkNode& node : tree.nodes) set_turned(node, node.start * chance.turn(size));
  update_frames(tree);
}

void update_frames(IkTree& tree) {
  for (IkNode& node : tree.nodes) {
    Columns& local = node.parent_from_frame;
    turn_axes(node.above, node.rotation, local.axis);
    local.origin = node.above.origin;
    if (&node == tree.nodes.data) local.origin = local.origin + turn(node.above, tree.travel);
    follow_parent(tree, node);
    if (tree.turns) node.turned = above_turned(tree, node) * node.rotation;
  }
  update_tips(tree);
}

void update_tips(IkTree& tree) {
  for (IkNode& tip : tree.tips) {
    follow_parent(tree, tip);
    if (tree.turns) tip.turned = above_turned(tree, tip);
  }
}

f32x4 rotation_error(const IkNode& tip) {
  return turn_of(WideRotation{load(tip.goal->rotation)} * conjugate(tip.turned));
}

float total_error(const IkTree& tree) {
  float sum = 0;
  for (const IkNode& tip : tree.tips) sum = with_error(sum, tip, position_error(tip));
  return sqrt(sum);
}

void set_turned(IkNode& node, WideRotation rotation) {
  if (!(node.ease_root > 0)) return;
  const float squared = dot4(rotation.v, rotation.v), k = sqrt(squared) * (1.0f / squared);
  if (!has_direction(squared)) return;
  node.rotation.v = rotation.v * k;
  if (node.limit != nullptr) node.rotation = clamped(*node.limit, node.rotation);
}

f32x4 turn_of(WideRotation rotation) {
  return log_of_shorter(normalised(rotation)).v;
}

void store_tree(const IkTree& tree, float weight, const Pose& pose) {
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    const IkNode& node = tree.nodes[i];
    const WideRotation from = node.start, to = node.rotation;
    if (same(from, to)) continue;
    WideRotation q = to;
    if (weight < 1) {
      const float other = dot4(from.v, to.v) < 0 ? weight - 1 : 1 - weight;
      q = normalised(WideRotation{from.v * other + to.v * weight});
    }
    set_rotation(pose.local, node.joint, q);
  }
  if (squared3(tree.travel) > 0) {
    const std::uint16_t joint = tree.nodes[0].joint;
    set_translation(pose.local, joint, wide_translation_of(pose.local, joint) + tree.travel * weight);
  }
  if (tree.stretch != 1) stretch_bones(pose, tree, 1.0f + (tree.stretch - 1.0f) * weight);
  for (const IkNode& node : tree.nodes) {
    if (node.parent == kNoJoint) update_below(pose, node.joint);
  }
}

}  // namespace marrow
