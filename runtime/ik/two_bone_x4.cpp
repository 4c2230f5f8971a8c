// Four limbs at once, a limb a lane.
#include "core/check.h"
#include "ik/goals.h"
#include "ik/two_bone.h"
#include "marrow/ik.h"
#include "math/elementary.h"

namespace marrow {
namespace {

// Four rows of four as a vector a limb, and what stands behind each.
struct Row {
  Vector<f32x4> xyz;
  f32x4 w;
};
inline Row transposed(const float* a, const float* b, const float* c, const float* d) {
  f32x4 x = load_aligned(a), y = load_aligned(b), z = load_aligned(c), w = load_aligned(d);
  transpose(x, y, z, w);
  return {{x, y, z}, w};
}

struct Four {
  Linear<f32x4> linear;
  Vector<f32x4> origin;
};
inline Four four(const Affine& a, const Affine& b, const Affine& c, const Affine& d) {
  const Row x = transposed(a.rows[0], b.rows[0], c.rows[0], d.rows[0]),
            y = transposed(a.rows[1], b.rows[1], c.rows[1], d.rows[1]),
            z = transposed(a.rows[2], b.rows[2], c.rows[2], d.rows[2]);
  return {{{x.xyz, y.xyz, z.xyz}}, {x.w, y.w, z.w}};
}

template <class Get>
inline f32x4 load_each(const TwoBone (&goals)[4], Get get) {
  const float each[4] = {get(goals[0]), get(goals[1]), get(goals[2]), get(goals[3])};
  return load(each);
}

inline void store_turns(const Turn<f32x4>& q, float (TwoBoneTurns::*member)[4], TwoBoneTurns (&out)[4]) {
  f32x4 a = q.axis.x, b = q.axis.y, c = q.axis.z, d = q.w;
  transpose(a, b, c, d);
  store(out[0].*member, a);
  store(out[1].*member, b);
  store(out[2].*member, c);
  store(out[3].*member, d);
}

template <bool plain>
inline bool solve_four(const TwoBoneJoints (&j)[4], const TwoBone (&g)[4], bool stretched, TwoBoneTurns (&out)[4]) {
  const Four start = four(*j[0].start, *j[1].start, *j[2].start, *j[3].start);
  const Four mid = four(*j[0].mid, *j[1].mid, *j[2].mid, *j[3].mid);
  const Four end = four(*j[0].end, *j[1].end, *j[2].end, *j[3].end);
  const Row target = transposed(g[0].target, g[1].target, g[2].target, g[3].target);
  const Row pole = transposed(g[0].pole, g[1].pole, g[2].pole, g[3].pole);
  const Row axis = transposed(g[0].bend_axis, g[1].bend_axis, g[2].bend_axis, g[3].bend_axis);
  const f32x4 weight_off = target.w - clamp_to_unit(target.w), soft_off = axis.w - clamp_to_unit(axis.w);
  if (!all(absolute(weight_off) + absolute(soft_off) < splat(kTinySquare))) return false;
  LimbProblem<f32x4> in = {mid.origin - start.origin,
                           end.origin - mid.origin,
                           target.xyz - start.origin,
                           start.linear,
                           mid.linear,
                           axis.xyz,
                           {pole.xyz, !all(absolute(pole.w) < splat(kTinySquare)), pole.w, pole.w},
                           axis.w,
                           stretched,
                           axis.w,
                           any(target.w < splat(1)),
                           target.w};
  if (stretched) in.max_stretch = load_each(g, [](const TwoBone& goal) { return goal.max_stretch; });
  if (!plain && in.about.twisted) {
    in.about.cos = load_each(g, [](const TwoBone& goal) { return cos_sin(goal.twist_rad).cos; });
    in.about.sin = load_each(g, [](const TwoBone& goal) { return cos_sin(goal.twist_rad).sin; });
  }
  LimbSolution<f32x4> s;
  if (!solve_limb<plain>(in, s)) return false;
  store_turns(s.start, &TwoBoneTurns::start, out);
  store_turns(s.mid, &TwoBoneTurns::mid, out);
  float stretch[4], over[4];
  store(stretch, s.stretch);
  store(over, s.miss - s.limb * splat(kNear));
  for (int k = 0; k < 4; ++k) {
    out[k].stretch = stretch[k];
    out[k].reached = over[k] < 0;
  }
  return true;
}

[[gnu::noinline, gnu::cold]] Status solve_any_four(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4],
                                                   bool stretched, TwoBoneTurns (&out)[4]) {
  for (const TwoBone& goal : goals) MARROW_REQUIRE(is_stretch(goal.max_stretch));
  MARROW_REQUIRE(solve_four<false>(joints, goals, stretched, out));
  return Status::ok;
}

}  // namespace

[[gnu::flatten]] Status two_bone_x4(const TwoBoneJoints (&joints)[4], const TwoBone (&goals)[4],
                                    TwoBoneTurns (&out)[4]) {
  const bool stretched = is_partial(goals[0].max_stretch) || is_partial(goals[1].max_stretch) ||
                         is_partial(goals[2].max_stretch) || is_partial(goals[3].max_stretch);
  if (!stretched && solve_four<true>(joints, goals, false, out)) return Status::ok;
  return solve_any_four(joints, goals, stretched, out);
}

}  // namespace marrow
