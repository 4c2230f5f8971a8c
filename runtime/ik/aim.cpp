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

// Target and aim in the joint's space without its scale.
struct View {
  Vector<One> way;                  // from the joint to the target
  Vector<One> forward, up, offset;  // see Aim
  bool apart;                       // the offset is not 0, so it is to be read
  About<One> about;
};

// Finds the unit direction that is to be turned onto the target's: from the joint to the point where the ray is as far
// from the joint as the target is; where it never is, to the ray's nearest point. False if there is no direction.
inline bool direction_of_ray(const View& view, One way_squared, Vector<One>& direction, bool& reached) {
  const One zero = all_lanes<One>(0), tiny = number<One>(kNumbers.tiny), one = number<One>(kNumbers.one);
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

// Turns the joint's ray onto the target, by `weight`; not at all where one of them has no direction. False if the
// numbers are not finite, or if `usual` and the view needs what is left out.
template <bool usual>
inline bool look(View view, float weight, AimTurn& out) {
  const One one = number<One>(kNumbers.one), tiny = number<One>(kNumbers.tiny);
  const One way_squared = dot(view.way, view.way);
  Quaternion<One> turn = unturned<One>();
  One squared = one;
  bool reached;
  if (Vector<One> from; direction_of_ray(view, way_squared, from, reached)) {
    Vector<One> normal = cross(view.up, from);
    const One normal_squared = dot(normal, normal);
    if (normal_squared < greater(number<One>(kNumbers.no_angle_squared) * dot(view.up, view.up), tiny)) {
      if constexpr (usual) return false;
      view.about.pole = Vector<One>{};
      normal = any_across(from);
    } else {
      normal = normal * (one / sqrt(normal_squared));
    }
    AnyTurn<One> whole;
    if (!turn_onto<usual>(from, normal, view.way * (one / sqrt(way_squared)), view.about, whole)) return false;
    turn = quaternion(whole.axis, whole.w);
    squared = squared_length(turn);
  } else {
    if constexpr (usual) return false;
    squared = one + (way_squared + dot(view.forward, view.forward) + dot(view.offset, view.offset)) *
                        all_lanes<One>(0x1p-24f);
  }
  if (!(squared < number<One>(kNumbers.huge))) return false;
  if (squared < tiny) {
    if constexpr (usual) return false;
    turn = unturned<One>(), squared = one;
  }
  turn = turn * (one / sqrt(squared));
  if (is_partial(weight)) turn = weighted_turn(turn, all_lanes<One>(weight));
  store(out.turn, turn.v);
  out.reached = reached;
  return true;
}

inline Vector<One> to_local(const Axes<One>& axes, Vector<One> v) {
  return without_w(direction_to_local(axes, v));
}

template <bool usual>
inline View view_from(const Affine& joint, const Aim& goal) {
  const Axes<One> axes = axes_of<usual>(joint);
  const Vector<One> lengths = without_w(axes.lengths);
  const Vector<One> forward = by_component(wide(goal.forward), lengths);
  View view = {to_local(axes, Vector<One>{load(goal.target)} - wide_origin(joint)),
               forward,
               by_component(wide(goal.up), lengths),
               forward,
               is_some(goal.offset),
               {to_local(axes, {load(goal.pole)}), is_some(goal.twist_rad), all_lanes<One>(goal.twist_rad)}};
  if (view.apart) view.offset = by_component(wide(goal.offset), lengths);
  return view;
}

template <bool usual>
inline bool aim_once(const Affine& joint, const Aim& goal, AimTurn& out) {
  return look<usual>(view_from<usual>(joint, goal), goal.weight, out);
}
[[gnu::noinline, gnu::cold]] bool aim_any(const Affine& joint, const Aim& goal, AimTurn& out) {
  return aim_once<false>(joint, goal, out);
}

// Joint i's share of the turn that the joints before it leave: falloff^m / (1 + falloff + … + falloff^m), with m joints
// after it.
float share_of(std::size_t i, std::size_t count, float falloff) {
  float share = 1, sum = 1;
  for (std::size_t after = i + 1; after < count; ++after) {
    share *= falloff;
    sum += share;
  }
  return share / sum;
}

inline Vector<One> to_model(const Affine& joint, const float (&v)[3]) {
  return transposed_times(wide_rows(joint), wide(v));
}
// v, turned by the inverse of q.
inline Vector<One> turned_back(Quaternion<One> q, Vector<One> v) {
  const Vector<One> t = cross(v, axis_part(q));
  return v + (t * w_of(q) + cross(t, axis_part(q))) * all_lanes<One>(2);
}

// Finds a joint's turn; false if the numbers are not finite. The gaze is a view in model space. When a joint has
// turned, the target and the pole are turned back, instead of all that hangs on the joint being turned.
bool turn_gaze(const Affine& joint, float weight, View& gaze, AimTurn& out) {
  const Axes<One> axes = axes_of<false>(joint);
  const Vector<One> at = wide_origin(joint), way = gaze.way - at;
  View view = gaze;
  view.way = way;
  view.offset = view.offset - at;
  for (Vector<One>* v : {&view.way, &view.forward, &view.up, &view.offset}) *v = to_local(axes, *v);
  view.about.pole = to_local(axes, view.about.pole);
  if (!look<false>(view, weight, out)) return false;
  const Quaternion<One> local = {load(out.turn)};
  const Quaternion<One> turn = quaternion(axis_to_model(axes, axis_part(local)), w_of(local));
  gaze.way = at + turned_back(turn, way);
  gaze.about.pole = turned_back(turn, gaze.about.pole);
  return true;
}

// Finds all joints' turns, and puts them into the pose if `for_good`. Gives the last turn. Bad if some number is not
// finite.
BadCall turn_joints(const Pose& pose, Span<const std::uint32_t> joints, const Aim& goal, float falloff, bool for_good,
                    AimTurn& turn) {
  const Affine& last = pose.model_from_joint[joints[joints.size - 1]];
  View gaze = {wide(goal.target),
               to_model(last, goal.forward),
               to_model(last, goal.up),
               to_model(last, goal.offset) + wide_origin(last),
               true,
               {wide(goal.pole), is_some(goal.twist_rad), all_lanes<One>(goal.twist_rad)}};
  for (std::size_t i = 0; i < joints.size; ++i) {
    const float weight = goal.weight * share_of(i, joints.size, falloff);
    MARROW_CHECK(turn_gaze(pose.model_from_joint[joints[i]], weight, gaze, turn) && "finite, not too large");
    if (for_good) turn_joint(pose.local, joints[i], turn.turn);
  }
  return {};
}

// Turns a chain, or one joint.
BadCall turn_chain(const Pose& pose, Span<const std::uint32_t> joints, const Aim& goal, float falloff, bool* reached) {
  if (const BadCall bad = check_chain(pose, joints)) return bad;
  MARROW_CHECK(is_share(goal.weight) && is_share(falloff));
  AimTurn turn;
  for (const bool for_good : {false, true}) {
    if (const BadCall bad = turn_joints(pose, joints, goal, falloff, for_good, turn)) return bad;
    if (reached != nullptr) *reached = turn.reached;
    if (goal.weight == 0) return {};
  }
  update_below(pose, joints[0]);
  return {};
}

}  // namespace

Status aim(const Affine& joint, const Aim& goal, AimTurn& out) {
  MARROW_REQUIRE(is_share(goal.weight));
  if (aim_once<true>(joint, goal, out)) [[likely]]
    return Status::ok;
  MARROW_REQUIRE(aim_any(joint, goal, out) && "finite, not too large");
  return Status::ok;
}

Status solve_aim(const Pose& pose, std::uint32_t joint, const Aim& goal, bool* reached) {
  MARROW_REQUIRE_GOOD(turn_chain(pose, {&joint, 1}, goal, 1, reached));
  return Status::ok;
}

Status solve_look_at(const Pose& pose, Span<const std::uint32_t> joints, const Aim& goal, float falloff,
                     bool* reached) {
  MARROW_REQUIRE_GOOD(turn_chain(pose, joints, goal, falloff, reached));
  return Status::ok;
}

}  // namespace marrow
