#include "core/check.h"
#include "ik/goals.h"
#include "ik/turn_joint.h"
#include "ik/turn_onto.h"
#include "marrow/ik.h"
#include "marrow/local_to_model.h"
#include "math/affine.h"
#include "math/elementary.h"

namespace marrow {
namespace {

// All that a turn depends on, in the joint's local space without its scale.
struct View {
  Vector<One> way;  // from the joint to the target
  Vector<One> forward, up, offset;
  bool apart;  // the offset is not 0; if it is, it does not count
  About<One> about;
};

struct Seen {
  Quaternion<One> turn;
  bool reached;
};

// The unit direction, seen from the joint, of what is to be turned onto the target: of the point where the ray is as
// far away as the target, or, if it never is, of the nearest; and whether the target can be met.
template <bool plain>
inline bool direction_of_ray(const View& view, One way_squared, Vector<One>& direction, bool& reached) {
  const One zero = all_lanes<One>(0), tiny = all_lanes<One>(kTinySquare), one = all_lanes<One>(1);
  One squared = dot(view.forward, view.forward);
  reached = tiny < lesser(way_squared, squared);
  if (!reached) return false;
  direction = view.forward * (one / sqrt(squared));
  if (!view.apart) return true;
  const One along = dot(view.offset, direction), off = dot(view.offset, view.offset);
  const One rest = along * along + (way_squared - off), to_sphere = sqrt(greater(rest, zero)) - along;
  reached = !(rest < zero) && !(to_sphere < zero);
  const Vector<One> point = view.offset + direction * to_sphere;
  squared = dot(point, point);
  if (!(tiny < squared)) return false;
  direction = point * (one / sqrt(squared));
  return true;
}

// As turn_onto; the identity where there are no directions. False also if the numbers are not finite.
template <bool plain>
inline bool look(const View& view, Seen& out) {
  const One zero = all_lanes<One>(0), one = all_lanes<One>(1);
  const One way_squared = dot(view.way, view.way);
  Vector<One> from;
  bool directed = direction_of_ray<plain>(view, way_squared, from, out.reached);
  if (!directed) {
    if constexpr (plain) return false;
    const One sum = way_squared + dot(view.forward, view.forward) + dot(view.offset, view.offset);
    out.turn = quaternion(vector_of(zero, zero, zero), one);
    return sum < all_lanes<One>(kHugeSquare);
  }
  About<One> about = view.about;
  Vector<One> normal = cross(view.up, from);
  const One squared = dot(normal, normal);
  if (const auto along =
          squared < all_lanes<One>(1e-10f) * dot(view.up, view.up) || squared < all_lanes<One>(kTinySquare);
      !plain && along) {
    about.pole = vector_of(zero, zero, zero);
    normal = any_across(from);
  } else {
    if (plain && along) return false;
    normal = normal * (one / sqrt(squared));
  }
  Quaternion<One> turn;
  if (!turn_onto<plain>(from, normal, view.way * (one / sqrt(way_squared)), about, turn)) return false;
  const One turn_squared = squared_length(turn);
  if (!(turn_squared < all_lanes<One>(kHugeSquare))) return false;
  if (plain && !(all_lanes<One>(kTinySquare) < turn_squared)) return false;
  out.turn = unit_turn<plain>(turn, turn_squared);
  return true;
}

inline Vector<One> to_local(const Axes<One>& axes, const Vector<One>& v) {
  return without_w(direction_to_local(axes, v));
}

template <bool plain>
inline View view_from(const Affine& joint, const Aim& goal) {
  const Axes<One> axes = axes_of<plain>(wide_rows(joint));
  const Vector<One> lengths = without_w(axes.lengths), forward = by_component(wide(goal.forward), lengths);
  View view = {to_local(axes, wide(goal.target) - wide_origin(joint)),
               forward,
               by_component(wide(goal.up), lengths),
               forward,
               is_some(goal.offset),
               {to_local(axes, wide(goal.pole)), is_some(goal.twist_rad), {}, {}}};
  if (view.apart) view.offset = by_component(wide(goal.offset), lengths);
  return view;
}

inline void add_twist(const Aim& goal, About<One>& about) {
  if (!about.twisted) return;
  const CosSin twist = cos_sin(goal.twist_rad);
  about.cos = all_lanes<One>(twist.cos);
  about.sin = all_lanes<One>(twist.sin);
}

inline void store_turn(const Seen& seen, float weight, AimTurn& out) {
  const Quaternion<One> turn = !is_partial(weight) ? seen.turn : part_of(seen.turn, all_lanes<One>(weight));
  store(out.turn, turn.v);
  out.reached = seen.reached;
}

[[gnu::noinline, gnu::cold]] BadCall aim_any(const Affine& joint, const Aim& goal, AimTurn& out) {
  MARROW_CHECK(is_share(goal.weight));
  View view = view_from<false>(joint, goal);
  add_twist(goal, view.about);
  Seen seen;
  MARROW_CHECK(look<false>(view, seen) && "finite, not too large");
  store_turn(seen, goal.weight, out);
  return {};
}

// How a joint of a chain must turn so that the last one looks at the target.
bool look_by(const Affine& joint, const Affine& last, const Aim& goal, float weight, AimTurn& out) {
  const Axes<One> axes = axes_of<false>(wide_rows(joint));
  const Vector3 eye = transform(last, vector3(goal.offset)) - origin(joint);
  View view = {to_local(axes, wide(goal.target) - wide_origin(joint)),
               to_local(axes, wide(turn(last, vector3(goal.forward)))),
               to_local(axes, wide(turn(last, vector3(goal.up)))),
               to_local(axes, wide(eye)),
               true,
               {to_local(axes, wide(goal.pole)), is_some(goal.twist_rad), {}, {}}};
  add_twist(goal, view.about);
  Seen seen;
  if (!look<false>(view, seen)) return false;
  store_turn(seen, weight, out);
  return true;
}

// The rotation about the joint's place that a turn in its local space is in the scene.
Affine as_moved(const Affine& joint, const float (&local_turn)[4]) {
  const Axes<One> axes = axes_of<false>(wide_rows(joint));
  float v[4];
  store(v, axis_to_scene(axes, wide(local_turn)).v);
  const Rotation q = quaternion(vector3(v), local_turn[3]);
  const Vector3 at = origin(joint);
  return affine({rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})}, at - rotate(q, at));
}

// What part of what is left joint i of `count` does: falloff^m / (1 + falloff + … + falloff^m), m joints being after
// it.
float share_of(std::size_t i, std::size_t count, float falloff) {
  float share = 1, sum = 1;
  for (std::size_t after = i + 1; after < count; ++after) {
    share *= falloff;
    sum += share;
  }
  return share / sum;
}

// The turn of joint i, after those before it have turned; `moved` is what they do to all that hangs on them.
bool turn_of_chain(Span<const std::uint32_t> joints, std::size_t i, const Aim& goal, float falloff,
                   Span<const Affine> scene_from_joint, Affine& moved, AimTurn& out) {
  Affine joint, last;
  multiply(moved, scene_from_joint[joints[i]], joint);
  multiply(moved, scene_from_joint[joints[joints.size - 1]], last);
  if (!look_by(joint, last, goal, goal.weight * share_of(i, joints.size, falloff), out)) return false;
  Affine all;
  multiply(as_moved(joint, out.turn), moved, all);
  moved = all;
  return true;
}

// Of a chain, or of one joint.
BadCall turn_chain(const Skeleton& skeleton, Span<const std::uint32_t> joints, const Aim& goal, float falloff,
                   Span<SoaTransform> local, Span<Affine> scene_from_joint, bool* reached) {
  MARROW_CHECK(holds(local, skeleton.soa_size()));
  MARROW_CHECK(holds(scene_from_joint, skeleton.joint_count));
  MARROW_CHECK(is_share(goal.weight) && is_share(falloff));
  MARROW_CHECK(holds(joints) && !joints.empty() && joints[0] < skeleton.joint_count);
  for (std::size_t i = 1; i < joints.size; ++i) {
    MARROW_CHECK(joints[i - 1] < joints[i] && joints[i] < skeleton.joint_count);
    MARROW_CHECK(hangs_below(skeleton, joints[i], joints[i - 1]));
  }
  AimTurn turn;
  Affine moved = kIdentity;  // once without writing: the last may fail
  for (std::size_t i = 0; i < joints.size; ++i)
    MARROW_CHECK(turn_of_chain(joints, i, goal, falloff, scene_from_joint, moved, turn) && "finite, not too large");
  if (reached != nullptr) *reached = turn.reached;
  if (goal.weight == 0) return {};
  moved = kIdentity;
  for (std::size_t i = 0; i < joints.size; ++i) {
    (void)turn_of_chain(joints, i, goal, falloff, scene_from_joint, moved, turn);
    turn_joint(local, joints[i], turn.turn);
  }
  (void)local_to_model_below(skeleton, local, joints[0], scene_from_joint);
  return {};
}

}  // namespace

[[gnu::flatten]] Status aim(const Affine& joint, const Aim& goal, AimTurn& out) {
  if (is_plain_share(goal.weight) && !is_some(goal.twist_rad)) {
    const View view = view_from<true>(joint, goal);
    if (Seen seen; look<true>(view, seen)) {
      store_turn(seen, goal.weight, out);
      return Status::ok;
    }
  }
  MARROW_REQUIRE_GOOD(aim_any(joint, goal, out));
  return Status::ok;
}

Status solve_aim(const Skeleton& skeleton, std::uint32_t joint, const Aim& goal, Span<SoaTransform> local,
                 Span<Affine> scene_from_joint, bool* reached) {
  MARROW_REQUIRE_GOOD(turn_chain(skeleton, {&joint, 1}, goal, 1, local, scene_from_joint, reached));
  return Status::ok;
}

Status solve_look_at(const Skeleton& skeleton, Span<const std::uint32_t> joints, const Aim& goal, float falloff,
                     Span<SoaTransform> local, Span<Affine> scene_from_joint, bool* reached) {
  MARROW_REQUIRE_GOOD(turn_chain(skeleton, joints, goal, falloff, local, scene_from_joint, reached));
  return Status::ok;
}

}  // namespace marrow
