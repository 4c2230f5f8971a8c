#include "ik/two_bone.h"

#include "core/check.h"
#include "core/fixed.h"
#include "ik/goals.h"
#include "ik/turn_joint.h"
#include "marrow/ik.h"
#include "marrow/local_to_model.h"
#include "math/elementary.h"

namespace marrow {
namespace {

template <bool plain>
inline LimbProblem<One> problem(const TwoBoneJoints& joints, const TwoBone& goal) {
  const Vector<One> start = wide_origin(*joints.start), mid = wide_origin(*joints.mid), end = wide_origin(*joints.end);
  return {mid - start,
          end - mid,
          wide(goal.target) - start,
          wide_rows(*joints.start),
          wide_rows(*joints.mid),
          {load_aligned(goal.bend_axis)},
          {plain ? Vector<One>{load_aligned(goal.pole)} : wide(goal.pole), is_some(goal.twist_rad),
           all_lanes<One>(goal.twist_rad)},
          all_lanes<One>(goal.soft),
          is_partial(goal.max_stretch),
          all_lanes<One>(goal.max_stretch),
          is_partial(goal.weight),
          all_lanes<One>(goal.weight)};
}

// False if the numbers are not finite; see solve_limb().
template <bool plain>
inline bool solve_one(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  LimbProblem<One> in = problem<plain>(joints, goal);
  LimbSolution<One> s;
  if (!solve_limb<plain>(in, s)) return false;
  store(out.start, s.start.v);
  store(out.mid, s.mid.v);
  out.stretch = first_lane(s.stretch.v);
  const One near = s.limb * number<One>(kNumbers.near);
  out.reached = s.miss_squared < near * near;
  return true;
}

[[gnu::noinline, gnu::cold]] BadCall solve_any(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  MARROW_CHECK(is_share(goal.weight) && is_share(goal.soft));
  MARROW_CHECK(is_stretch(goal.max_stretch));
  MARROW_CHECK(solve_one<false>(joints, goal, out) && "finite, not too large");
  return {};
}

// The kernel, of joints that are there.
[[gnu::noinline, gnu::flatten]] BadCall solve_reach(const TwoBoneJoints& joints, const TwoBone& goal,
                                                    TwoBoneTurns& out) {
  const bool usual = is_plain_share(goal.weight) && is_plain_share(goal.soft) && is_stretch(goal.max_stretch);
  if (!kSmall && usual && solve_one<true>(joints, goal, out)) return {};
  return solve_any(joints, goal, out);
}

// The translations of `joint` and of all above it up to `start`, which stays as it is.
void stretch_limb(const Skeleton& skeleton, std::uint32_t start, std::uint32_t joint, float stretch,
                  Span<SoaTransform> local) {
  for (; joint != start; joint = skeleton.parents[joint])
    for (float(&axis)[4] : local[joint / 4].translation) axis[joint % 4] *= stretch;
}

void turn_limb(Span<SoaTransform> local, const TwoBoneLimb& limb, const TwoBoneTurns& turns) {
  turn_joint(local, limb.start, turns.start);
  turn_joint(local, limb.mid, turns.mid);
}

}  // namespace

Status two_bone(const TwoBoneJoints& joints, const TwoBone& goal, TwoBoneTurns& out) {
  MARROW_REQUIRE(joints.start != nullptr && joints.mid != nullptr && joints.end != nullptr);
  MARROW_REQUIRE_GOOD(solve_reach(joints, goal, out));
  return Status::ok;
}

BadCall reach(const Skeleton& skeleton, const TwoBoneLimb& limb, const TwoBone& goal, Span<SoaTransform> local,
              Span<Affine> scene_from_joint, bool* reached) {
  const std::uint32_t chain[] = {limb.start, limb.mid, limb.end};
  if (const BadCall bad = check_chain(skeleton, local, scene_from_joint, {chain, 3})) return bad;
  const Affine* const joints = scene_from_joint.data;
  const TwoBoneJoints at = {joints + limb.start, joints + limb.mid, joints + limb.end};
  TwoBoneTurns turns;
  if (const BadCall bad = solve_reach(at, goal, turns)) return bad;
  if (reached != nullptr) *reached = turns.reached;
  if (goal.weight == 0) return {};
  turn_limb(local, limb, turns);
  if (turns.stretch != 1) stretch_limb(skeleton, limb.start, limb.end, turns.stretch, local);
  (void)local_to_model_below(skeleton, local, limb.start, scene_from_joint);
  return {};
}

Status solve_two_bone(const Skeleton& skeleton, const TwoBoneLimb& limb, const TwoBone& goal, Span<SoaTransform> local,
                      Span<Affine> scene_from_joint, bool* reached) {
  MARROW_REQUIRE_GOOD(reach(skeleton, limb, goal, local, scene_from_joint, reached));
  return Status::ok;
}

}  // namespace marrow
