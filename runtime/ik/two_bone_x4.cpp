// two_bone_x4(): four limbs at once, a limb a lane.
#include "core/check.h"
#include "ik/goals.h"
#include "ik/two_bone.h"
#include "marrow/ik.h"
#include "math/elementary.h"

namespace marrow {
namespace {

template <class Get>
inline f32x4 load_each(const TwoBone (&goals)[4], Get get) {
  const float each[4] = {get(goals[0]), get(goals[1]), get(goals[2]), get(goals[3])};
  return load(each);
}

inline void store_turns(const Quaternion<f32x4>& q, float (TwoBoneTurns::*member)[4], TwoBoneTurns (&out)[4]) {
  f32x4 a = q.x, b = q.y, c = q.z, d = q.w;
  transpose(a, b, c, d);
  store(out[0].*member, a);
  store(out[1].*member, b);
  store(out[2].*member, c);
  store(out[3].*member, d);
}

template <bool usual>
inline bool solve_four(const TwoBoneJoints (&j)[4], const TwoBone (&g)[4], bool stretched, TwoBoneTurns (&out)[4]) {
  const FourAffines start = load_affines(*j[0].start, *j[1].start, *j[2].start, *j[3].start);
  const FourAffines mid = load_affines(*j[0].mid, *j[1].mid, *j[2].mid, *j[3].mid);
  const FourAffines end = load_affines(*j[0].end, *j[1].end, *j[2].end, *j[3].end);
  const FourRows target = load_rows(g[0].target, g[1].target, g[2].target, g[3].target);
  const FourRows pole = load_rows(g[0].pole, g[1].pole, g[2].pole, g[3].pole);
  const FourRows axis = load_rows(g[0].bend_axis, g[1].bend_axis, g[2].bend_axis, g[3].bend_axis);
  const f32x4 weight_off = target.origin - clamp_to_unit(target.origin),
              soft_off = axis.origin - clamp_to_unit(axis.origin);
  if (!all(absolute(weight_off) + absolute(soft_off) < number<f32x4>(kNumbers.tiny))) return false;
  LimbProblem<f32x4> in = {{origin(mid) - origin(start), origin(end) - origin(mid), target.linear - origin(start)},
                           linear_rows(start),
                           linear_rows(mid),
                           axis.linear,
                           pole.linear,
                           !all(absolute(pole.origin) < number<f32x4>(kNumbers.tiny)),
                           pole.origin,
                           axis.origin,
                           stretched,
                           axis.origin,
                           any(target.origin < splat(1)),
                           target.origin};
  if (stretched) in.max_stretch = load_each(g, [](const TwoBone& goal) { return goal.max_stretch; });
  LimbSolution<f32x4> s;
  if (!solve_limb<usual>(in, s)) return false;
  store_turns(s.start, &TwoBoneTurns::start, out);
  store_turns(s.mid, &TwoBoneTurns::mid, out);
  const f32x4 near = s.limb * number<f32x4>(kNumbers.near);
  float stretch[4], over[4];
  store(stretch, s.stretch);
  store(over, s.miss_squared - near * near);
  for (int k = 0; k < 4; ++k) {
    out[k].stretch = stretch[k];
    out[k].reached = over[k] < 0;
  }
  return true;
}

[[gnu::noinline, gnu::cold]] bool solve_any_four(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4],
                                                 bool stretched, TwoBoneTurns (&out)[4]) {
  return solve_four<false>(joints, goals, stretched, out);
}

}  // namespace

[[gnu::flatten]] Status two_bone_x4(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4],
                                    TwoBoneTurns (&out)[4]) {
  for (const TwoBoneJoints& j : joints) MARROW_REQUIRE(j.start != nullptr && j.mid != nullptr && j.end != nullptr);
  for (const TwoBone& goal : goals) MARROW_REQUIRE(is_stretch(goal.max_stretch));
  const bool stretched = is_partial(goals[0].max_stretch) || is_partial(goals[1].max_stretch) ||
                         is_partial(goals[2].max_stretch) || is_partial(goals[3].max_stretch);
  if (!stretched && solve_four<true>(joints, goals, false, out)) [[likely]]
    return Status::ok;
  MARROW_REQUIRE(solve_any_four(joints, goals, stretched, out) && "shares 0 ... 1, finite, not too large");
  return Status::ok;
}

}  // namespace marrow
