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

// What is above a node, up to the node that it hangs on, or to the scene.
void set_above(const PosedJoints& pose, const std::uint16_t* node_of, IkNode& node) {
  const Skeleton& skeleton = pose.skeleton;
  const Span<const SoaTransform> local = pose.local;
  std::uint16_t on = skeleton.parents[node.joint];
  while (on != kNoParent && node_of[on] == kNoParent) on = skeleton.parents[on];
  const bool top = on == kNoParent;
  node.parent = top ? kNoParent : node_of[on];
  Columns above = {{}, wide_translation_of(local, node.joint)};
  set_axes(no_turn(), above.axis);
  WideRotation turned = no_turn();
  std::uint16_t joint = node.joint;
  for (std::uint16_t next; (next = skeleton.parents[joint]) != on; joint = next) {
    if (!top) multiply(local_frame(local, next), above, above);
    turned = wide_rotation_of(local, next) * turned;
  }
  if (top) {
    multiply(columns(map_above(pose, node.joint)), above, above);
    turned = rotation_of(skeleton.scene_from_root[joint]) * turned;
  } else {
    const f32x4 scale = wide_scale_of(local, on);
    for (f32x4& axis : above.axis) axis = axis * scale;
    above.origin = above.origin * scale;
  }
  node.above = above;
  node.above_turned = turned;
}

void set_end(const PosedJoints& pose, const std::uint16_t* node_of, IkEnd& end) {
  const Span<const SoaTransform> local = pose.local;
  std::uint16_t joint = end.goal->joint;
  f32x4 point = load_wide(end.goal->offset), bone = splat(0.0f);
  WideRotation rotation = no_turn();
  for (; node_of[joint] == kNoParent; joint = pose.skeleton.parents[joint]) {
    const Columns frame = local_frame(local, joint);
    point = transform(frame, point);
    bone = transform(frame, bone);
    rotation = wide_rotation_of(local, joint) * rotation;
  }
  end.node = node_of[joint];
  const f32x4 scale = wide_scale_of(local, joint);
  end.point = point * scale;
  end.bone = bone * scale;
  end.rotation = rotation;
}

void set_translation(Span<SoaTransform> local, std::size_t joint, f32x4 to) {
  set_three_of_lane(&local[joint / 4].translation[0][joint % 4], to);
}

// Translations of all joints from the goal's up to, and not with, the first that turns.
void stretch_bones(const PosedJoints& pose, const IkTree& tree, float factor) {
  for (std::uint16_t j = tree.ends[0].goal->joint; j != tree.nodes[0].joint; j = pose.skeleton.parents[j])
    set_translation(pose.local, j, wide_translation_of(pose.local, j) * factor);
}

}  // namespace

IkTree place_tree(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch) {
  return {scratch.take<IkNode>(problem.joints.size), scratch.take<IkEnd>(problem.goals.size),
          scratch.take<std::uint16_t>(skeleton.joint_count).data};
}

BadCall build_tree(const IkCall& call, IkTree& tree) {
  const Skeleton& skeleton = call.pose.skeleton;
  const IkProblem& problem = call.problem;
  constexpr std::uint16_t kMayTurn = 0xFFFE, kMoves = 0xFFFD;  // and moves a goal
  std::uint16_t* const node_of = tree.node_of;
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) node_of[j] = kNoParent;
  for (const std::uint16_t j : problem.joints) node_of[j] = kMayTurn;
  for (const IkGoal& goal : problem.goals) {
    bool moves = false;
    for (std::uint16_t j = goal.joint; j != kNoParent; j = skeleton.parents[j]) {
      if (node_of[j] == kNoParent) continue;
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
      node_of[joint] = kNoParent;
      continue;
    }
    IkNode& node = tree.nodes[count];
    node.joint = joint;
    node.place = static_cast<std::uint16_t>(i);
    node.ease_root = problem.stiffness.empty() ? 1.0f : sqrt(1.0f - problem.stiffness[i]);
    node.rotation = node.start = wide_rotation_of(call.pose.local, joint);
    node.limit = find_limit(problem.limits, joint);
    node.hinge = splat(0.0f);
    if (node.limit != nullptr && node.limit->kind == LimitKind::hinge)
      node.hinge = rotate({load(node.limit->joint_from_limit)}, lanes(1.0f, 0.0f, 0.0f, 0.0f));
    set_above(call.pose, node_of, node);
    if (node.limit != nullptr && node.ease_root > 0) node.rotation = clamped(*node.limit, node.rotation);
    node_of[joint] = count++;
  }
  tree.nodes.size = count;
  update_frames(tree);
  f32x4 sum = splat(0.0f);
  for (const IkNode& node : tree.nodes) {
    sum = sum + node.frame.axis[0] + node.frame.axis[1] + node.frame.axis[2] + node.above_turned.v;
  }
  const IkGoal* goal = problem.goals.data;
  for (IkEnd& end : tree.ends) {
    end.goal = goal++;
    set_end(call.pose, node_of, end);
    sum = sum + transform(tree.nodes[end.node].frame, end.point) + end.rotation.v;
  }
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
    if (node.parent == kNoParent) {
      node.frame = local;
    } else {
      multiply(tree.nodes[node.parent].frame, local, node.frame);
    }
    if (tree.turns) node.turned = above_turned(tree, node) * node.rotation;
  }
}

f32x4 rotation_error(const IkTree& tree, const IkEnd& end) {
  const WideRotation to = {load(end.goal->rotation)};
  return turn_of(to * conjugate(tree.nodes[end.node].turned * end.rotation));
}

float total_error(const IkTree& tree) {
  float sum = 0;
  for (const IkEnd& end : tree.ends) sum = with_error(sum, tree, end, position_error(tree, end));
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

void store_tree(const IkTree& tree, float weight, const PosedJoints& pose) {
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
    if (node.parent == kNoParent) update_below(pose, node.joint);
  }
}

}  // namespace marrow
