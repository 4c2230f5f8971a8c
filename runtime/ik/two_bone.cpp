#include "ik/two_bone.h"

#include "core/check.h"
#include "core/opaque.h"
#include "ik/goals.h"
#include "ik/turn_joint.h"
#include "marrow/ik.h"
#include "marrow/local_to_model.h"
#include "math/elementary.h"
#include "math/finite.h"

namespace marrow {
namespace {

constexpr int kMostSteps = 10;

inline LimbProblem<One> problem(const TwoBoneJoints& joints, const TwoBone& goal) {
  const Vector<One> start = wide_origin(*joints.start), mid = wide_origin(*joints.mid), end = wide_origin(*joints.end);
  return {{mid - start, end - mid, wide(goal.target) - start},
          *joints.start,
          *joints.mid,
          {load_aligned(goal.bend_axis)},
          wide(goal.pole),
          is_some(goal.twist_rad),
          all_lanes<One>(goal.twist_rad),
          all_lanes<One>(goal.soft),
          is_partial(goal.max_stretch),
          all_lanes<One>(goal.max_stretch),
          is_partial(goal.weight),
          all_lanes<One>(goal.weight)};
}

template <bool usual>
inline bool solve_one(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  LimbProblem<One> in = problem(joints, goal);
  LimbSolution<One> s;
  if (!solve_limb<usual>(in, s)) return false;
  store(out.start, s.start.v);
  store(out.mid, s.mid.v);
  out.stretch = first_lane(s.stretch.v);
  const One near = s.limb * number<One>(kNumbers.near);
  out.reached = s.miss_squared < near * near;
  return true;
}
[[gnu::noinline, gnu::cold]] bool solve_any(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  return solve_one<false>(joints, goal, out);
}

// The kernel. No pointer in `joints` may be null.
[[gnu::noinline, gnu::flatten]] BadCall solve_limb(const TwoBoneJoints& joints, const TwoBone& goal,
                                                   TwoBoneTurns& out) {
  MARROW_CHECK(is_share(goal.weight) && is_share(goal.soft));
  MARROW_CHECK(is_stretch(goal.max_stretch));
  if (solve_one<true>(joints, goal, out)) [[likely]]
    return {};
  MARROW_CHECK(solve_any(joints, goal, out) && "finite, not too large");
  return {};
}

// Scales the translations of all joints from below the start joint down to the end joint.
void stretch_limb(const Pose& pose, const TwoBoneLimb& limb, float stretch) {
  for (std::uint32_t joint = limb.end; joint != limb.start; joint = pose.skeleton.parents[joint])
    for (float(&axis)[4] : pose.local[joint / 4].translation) axis[joint % 4] *= stretch;
}

// A direction, turned by the map.
Vector<One> through(const Affine& m, Vector<One> v) {
  return transposed_times(wide_rows(m), v);
}

// Whether a map is more than a turn, or a mirror, and one scale. If it is no more than that, its rows are perpendicular
// and of one length.
[[gnu::noinline]] bool is_uneven(const Affine& m) {
  const Vector<One> first = wide(m.rows[0]);
  const One squared = dot(first, first);
  One off = all_lanes<One>(0);
  for (int i = 0; i < 3; ++i) {
    const Vector<One> apart = through(m, wide(m.rows[i])) - Vector<One>{load_aligned(kUnitAxes[i])} * squared;
    off = off + dot(apart, apart);
  }
  return !(off < all_lanes<One>(1e-10f) * (squared * squared));
}

// The inverse of a map's linear part; not finite if the map is flat.
[[gnu::noinline]] Affine inverse_of(const Affine& m) {
  f32x4 x = load_aligned(m.rows[0]), y = load_aligned(m.rows[1]), z = load_aligned(m.rows[2]), w = splat(0.0f);
  transpose(x, y, z, w);
  const Linear<One> c = {{x}, {y}, {z}}, rows = cofactors(c);
  const One over = number<One>(kNumbers.one) / dot(c.x, rows.x);
  Affine out;
  store(out.rows[0], (rows.x * over).v);
  store(out.rows[1], (rows.y * over).v);
  store(out.rows[2], (rows.z * over).v);
  return out;
}

// A limb under uneven scale: it changes its shape as its joints turn. Yet in the space of a joint's parent, that joint
// turns what is below it rigidly. So the limb is bent in the space of the middle joint's parent, and turned in that of
// the start joint's parent.
struct UnevenLimb {
  const Pose& pose;
  const TwoBoneLimb& limb;
  const TwoBoneJoints& at;
  Affine start_parent_from_model = inverse_of(map_above(pose, limb.start));
  Affine mid_parent_from_model = inverse_of(map_above(pose, limb.mid));
};

// Solves the limb in the space that `m` leads to; false if the numbers are not finite.
[[gnu::noinline]] bool solve_through(const UnevenLimb& u, const Affine& m, TwoBone& goal, Vector<One> target,
                                     TwoBoneTurns& turns) {
  Affine seen[3];
  const Affine* const joints[] = {u.at.start, u.at.mid, u.at.end};
  for (int i = 0; i < 3; ++i) multiply(m, *joints[i], seen[i]);
  store_wide(goal.target, through(m, target).v);
  return !solve_limb({seen, seen + 1, seen + 2}, goal, turns);
}

// Bends the limb until start and end are as far apart as start and target. Both distances are measured in the space of
// the start joint's parent. Steps of the secant method, each solved in the space of the middle joint's parent.
void bend_uneven(const UnevenLimb& u, const TwoBone& goal) {
  const Vector<One> start = wide_origin(*u.at.start);
  const auto length_through = [](const Affine& m, Vector<One> v) {
    const Vector<One> seen = through(m, v);
    return first_lane(sqrt(dot(seen, seen)).v);
  };
  const float want = length_through(u.start_parent_from_model, wide(goal.target) - start);
  TwoBone bent;
  store(bent.bend_axis, vector3(goal.bend_axis));
  float old_length = 0, old_seen = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector<One> now = wide_origin(*u.at.end) - start;
    const float length = length_through(u.mid_parent_from_model, now),
                seen = length_through(u.start_parent_from_model, now);
    const float off = want - seen, even = length / seen, slope = (length - old_length) / (seen - old_seen);
    if (absolute(off) <= 1e-6f * want) return;
    const float by = off * (within(slope, 0.25f * even, 4 * even) ? slope : even);
    TwoBoneTurns turns;
    if (!solve_through(u, u.mid_parent_from_model, bent, start + now * all_lanes<One>(1 + by / length), turns)) return;
    turn_joint(u.pose.local, u.limb.mid, turns.mid);
    update_below(u.pose, u.limb.mid);
    old_length = length, old_seen = seen;
  }
}

void turn_limb(Span<SoaTransform> local, const TwoBoneLimb& limb, const TwoBoneTurns& turns) {
  turn_joint(local, limb.start, turns.start);
  turn_joint(local, limb.mid, turns.mid);
}

// Blends a joint's rotation with `from`: the share `share` of the rotation that it has, and the rest of `from`.
[[gnu::noinline]] void blend_back(Span<SoaTransform> local, std::size_t joint, Quaternion<One> from, float share) {
  const Quaternion<One> to = wide_rotation_of(local, joint);
  const One same = {sum_of_lanes(from.v * to.v)};
  set_direction(local, joint, {from.v * splat(1 - share) + to.v * flip(all_lanes<One>(share), same).v});
}

// Whether the limb, once stretched, reaches the target. It may not if the secant method has not converged.
bool is_reached(const UnevenLimb& u, const TwoBone& goal, float stretch) {
  const Vector<One> start = wide_origin(*u.at.start), upper = wide_origin(*u.at.mid) - start,
                    way = wide_origin(*u.at.end) - start, lower = way - upper,
                    miss = wide(goal.target) - start - way * all_lanes<One>(stretch);
  const One near = (sqrt(dot(upper, upper)) + sqrt(dot(lower, lower))) * number<One>(kNumbers.near);
  return dot(miss, miss) < near * near;
}

// Bends the limb and turns it to the target, then mixes both turns with the pose by the goal's weight. The stretch is
// not applied: turns.stretch says what it is to be.
void turn_uneven(const UnevenLimb& u, const TwoBone& goal, TwoBoneTurns& turns) {
  const Quaternion<One> start = wide_rotation_of(u.pose.local, u.limb.start),
                        mid = wide_rotation_of(u.pose.local, u.limb.mid);
  bend_uneven(u, goal);
  TwoBone whole = goal;
  whole.weight = 1;
  store_wide(whole.pole, through(u.start_parent_from_model, wide(goal.pole)).v);
  const bool seen = solve_through(u, u.start_parent_from_model, whole, wide(goal.target), turns);
  turn_limb(u.pose.local, u.limb, turns);
  update_below(u.pose, u.limb.start);
  turns.reached = turns.reached && is_reached(u, goal, turns.stretch);
  if (!seen) return;  // the map above is flat
  blend_back(u.pose.local, u.limb.start, start, goal.weight);
  blend_back(u.pose.local, u.limb.mid, mid, goal.weight);
  turns.stretch = 1 + (turns.stretch - 1) * goal.weight;
}

}  // namespace

Status two_bone(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  MARROW_REQUIRE(joints.start != nullptr && joints.mid != nullptr && joints.end != nullptr);
  MARROW_REQUIRE_GOOD(solve_limb(joints, goal, out));
  return Status::ok;
}

BadCall solve_limb_of_pose(const Pose& pose, const TwoBoneLimb& limb, const TwoBone& goal, bool* reached) {
  MARROW_CHECK(limb.start < limb.mid && limb.mid < limb.end && limb.end < pose.skeleton.joint_count);
  const std::uint32_t chain[] = {limb.start, limb.mid, limb.end};
  if (const BadCall bad = check_chain(pose, {chain, 3})) return bad;
  const Affine* const joints = pose.model_from_joint.data;
  const TwoBoneJoints at = {joints + limb.start, joints + limb.mid, joints + limb.end};
  TwoBoneTurns turns;
  if (const BadCall bad = solve_limb(at, goal, turns)) return bad;
  if (goal.weight != 0) {
    if (is_uneven(map_above(pose, limb.start)) || is_uneven(map_above(pose, limb.mid))) {
      turn_uneven({pose, limb, at}, goal, turns);
    } else {
      turn_limb(pose.local, limb, turns);
    }
    if (turns.stretch != 1) stretch_limb(pose, limb, turns.stretch);
    update_below(pose, limb.start);
  }
  if (reached != nullptr) *reached = turns.reached;
  return {};
}

Status solve_two_bone(const Pose& pose, const TwoBoneLimb& limb, const TwoBone& goal, bool* reached) {
  MARROW_REQUIRE_GOOD(solve_limb_of_pose(pose, limb, goal, reached));
  return Status::ok;
}

}  // namespace marrow
