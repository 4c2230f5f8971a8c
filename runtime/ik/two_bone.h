// The kernel of a limb of two bones, for one limb or four: the same operations in the same order, so the same bits.
#pragma once

#include "core/check.h"
#include "ik/turn_joint.h"
#include "ik/turn_onto.h"
#include "marrow/ik.h"

namespace marrow {

// solve_two_bone() without its refusal: what is wrong with the call, or nothing.
BadCall solve_limb_of_pose(const PosedJoints& pose, const TwoBoneLimb& limb, const TwoBone& goal, bool* reached);

// Of a limb in the scene: from the start joint to the middle joint, from there to the end joint; from the start joint
// to the target.
template <class F>
struct LimbWays {
  Vector<F> upper, lower, way;
};

template <class F>
struct LimbProblem {
  LimbWays<F> ways;
  RowsOf<F> scene_from_start, scene_from_mid;
  Vector<F> bend_axis, pole;
  bool twisted;
  F twist_rad;  // if twisted
  F soft;
  bool stretched;  // some may be longer
  F max_stretch;   // if stretched
  bool partial;    // some weight is below 1
  F weight;        // if partial
};

template <class F>
struct LimbSolution {
  Quaternion<F> start, mid;
  F stretch;
  F miss_squared;
  F limb;  // its length
};

// The squared lengths of three vectors, as a vector; its w is the third again.
inline Vector<f32x4> squared_lengths(const Vector<f32x4>& a, const Vector<f32x4>& b, const Vector<f32x4>& c) {
  return {dot(a, a), dot(b, b), dot(c, c)};
}
inline Vector<One> squared_lengths(Vector<One> a, Vector<One> b, Vector<One> c) {
  return {three_sums(a.v * a.v, b.v * b.v, c.v * c.v)};
}
inline bool any_below(const Vector<f32x4>& v, f32x4 limit) {
  return any(lesser(lesser(v.x, v.y), v.z) < limit);
}
inline bool any_below(Vector<One> v, One limit) {
  return any(v.v < limit.v);
}

// The three lengths, and what the triangle of the bones and the way to the target is to be.
template <class F>
struct Triangle {
  F upper, lower, way;
  F half_cos, half_sin;  // of half the bend at the middle joint, both times any length; 0 is straight
  F along, across;       // cosine and sine of the angle at the start joint
  F stretch, limb, miss_squared;
};

template <class F>
inline void shape_triangle(const LimbProblem<F>& in, F inverse_upper, Triangle<F>& t) {
  const F one = number<F>(kNumbers.one), half = number<F>(kNumbers.half);
  const F sum = t.upper + t.lower, difference = t.upper - t.lower;
  F reach = t.way;
  t.stretch = one;
  if (const F firm = in.soft * sum; any(firm < reach)) {
    // sum - e (1 + z / 4)⁻⁴ with e = sum - firm, z = (reach - firm) / e: slope 1, then ever less.
    const F four = number<F>(kNumbers.four), e = sum - firm, over = greater(reach - firm, all_lanes<F>(0));
    const F g = four * e / (four * e + over), g2 = g * g;
    reach = select(firm < reach, sum - e * g2 * g2, reach);
    if (in.stretched) t.stretch = select(firm < t.way, greater(one, lesser(in.max_stretch, t.way / reach)), one);
  }
  const F least = greater(difference, t.lower - t.upper);
  reach = lesser(greater(reach, greater(least, number<F>(kNumbers.least_reach) * sum)), sum);
  t.half_cos = sqrt((reach - difference) * (reach + difference));
  t.half_sin = sqrt((sum - reach) * (sum + reach));
  const F inverse = one / reach, scale = half * inverse_upper;
  t.along = scale * (reach + difference * sum * inverse);
  t.across = scale * (t.half_cos * t.half_sin * inverse);
  t.limb = sum;
  const F miss = (in.stretched ? reach * t.stretch : reach) - t.way;
  t.miss_squared = miss * miss;
}

// The plane of the bones, and the middle joint's turn that bends them as the triangle says.
template <class F>
struct Bend {
  Vector<F> normal, to_end;  // unit; to_end: from start to end, once bent
  Quaternion<F> mid;         // of any length; its axis in the middle joint's space
  F agreed;  // cosine-like measure of how far the bend has the preferred sense; infinite or NaN: bad goal
};

// A unit vector across `unit`, next to v; `otherwise` where v's part across has a square below `enough`.
template <class F>
inline Vector<F> unit_across(Vector<F> v, Vector<F> unit, F enough, Vector<F> otherwise) {
  const Vector<F> part = across(v, unit);
  const F squared = dot(part, part);
  Vector<F> unit_part = part * inverse_root(squared);
  set_where(squared < enough, unit_part, otherwise);
  return unit_part;
}

// Bends a limb that is all but straight, or bent the other way than preferred. Its normal is mixed with the preferred
// axis until it has kStraight of that: so it always has a direction, and moves steadily. The lower bone is first turned
// straight about the normal that it has, then bent about the new one; a folded limb is folded shut, then opened.
template <class F>
inline Bend<F> bend_preferred(const LimbProblem<F>& in, const Axes<F>& mid_axes, Vector<F> upper, Vector<F> now, F sine,
                              F cosine, const Triangle<F>& triangle) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one), tiny = number<F>(kNumbers.tiny);
  const Vector<F> bend_axis = without_w(in.bend_axis);
  const auto free = dot(bend_axis, bend_axis) < tiny;
  Vector<F> wanted = axis_to_scene(mid_axes, bend_axis);
  set_where(free, wanted, cross(in.pole, upper));
  const F enough = greater(dot(wanted, wanted) * all_lanes<F>(1e-6f), tiny);
  Vector<F> axis = unit_across(wanted, upper, enough, any_across(upper));
  axis = across(axis, upper);  // again: if nearly all of it was along, much of what is left is rounding
  // The normal now is 2 sin(bend / 2) cos(bend / 2) long, which is `sine`; w is 2 cos²(bend / 2), or of a folded limb
  // -2 sin²(bend / 2).
  F agreed = dot(now, axis);
  set_where(free, agreed, sine);
  const F pull = greater(number<F>(kNumbers.straight) * number<F>(kNumbers.half) * (one + cosine) - agreed, zero);
  const Vector<F> normal = unit_across(now + axis * pull, upper, all_lanes<F>(1e-14f), axis);
  const auto folded = cosine < zero;
  F c = triangle.half_cos, s = triangle.half_sin, w = cosine + one;
  set_where(folded, c, triangle.half_sin);
  set_where(folded, s, zero - triangle.half_cos);
  set_where(folded, w, cosine - one);
  const Quaternion<F> turn =
      quaternion(normal * (s * w) - now * c - cross(normal, now) * s, c * w + s * dot(normal, now));
  const F sign = flip(one, w_of(turn));
  return {normal, upper * triangle.along + cross(normal, upper) * triangle.across,
          quaternion(axis_to_local(mid_axes, axis_part(turn)), w_of(turn)) * sign, agreed};
}

template <bool usual, class F>
inline bool bend_limb(const LimbProblem<F>& in, Vector<F> upper, Vector<F> lower, const Triangle<F>& triangle,
                      Bend<F>& bend) {
  const F one = number<F>(kNumbers.one), straight = number<F>(kNumbers.straight);
  const Axes<F> mid_axes = axes_of<usual>(in.scene_from_mid);
  const Vector<F> normal = cross(upper, lower), local = without_w(axis_to_local(mid_axes, normal));
  const F sine = sqrt(dot(normal, normal)), inverse = one / sine, cosine = dot(upper, lower);
  const F w = one + cosine, c = triangle.half_cos, s = triangle.half_sin, side = triangle.across * inverse;
  bend = {normal * inverse, upper * (triangle.along - side * cosine) + lower * side,
          quaternion(local * (s * w * inverse - c), c * w + s * sine), dot(local, in.bend_axis)};
  if (!all(straight < bend.agreed)) {
    const Vector<F> bend_axis = without_w(in.bend_axis);
    set_where(dot(bend_axis, bend_axis) < number<F>(kNumbers.tiny), bend.agreed, sine);
    if (const auto bent = straight < bend.agreed; !all(bent)) {
      if constexpr (usual) return false;
      Bend<F> other = bend_preferred(in, mid_axes, upper, normal, sine, cosine, triangle);
      set_where(bent, other.normal, bend.normal);
      set_where(bent, other.to_end, bend.to_end);
      set_where(bent, other.mid, bend.mid);
      other.agreed = bend.agreed;
      bend = other;
    }
  }
  return true;
}

// Gives bones of no length, and the way to a target at the start joint, a direction and next to no length. turns: 0
// where the whole limb has no length, so that nothing is to be turned; else 1.
template <class F>
inline LimbWays<F> with_lengths(LimbWays<F> in, F& turns) {
  const F tiny = number<F>(kNumbers.tiny), least = all_lanes<F>(0x1p-49f);
  const auto no_upper = dot(in.upper, in.upper) < tiny;  // one bone, from the start to the end
  set_where(no_upper, in.upper, in.lower);
  set_where(no_upper, in.lower, Vector<F>{});
  const auto no_limb = dot(in.upper, in.upper) < tiny;
  set_where(no_limb, in.upper, any_across(Vector<F>{}) * all_lanes<F>(0x1p-40f));
  turns = select(no_limb, all_lanes<F>(0), number<F>(kNumbers.one));
  const Vector<F> along_upper = in.upper * (least * inverse_root(dot(in.upper, in.upper)));
  set_where(dot(in.lower, in.lower) < tiny, in.lower, along_upper);
  const Vector<F> now = in.upper + in.lower;
  const F squared = dot(now, now);
  Vector<F> along_limb = now * (least * inverse_root(squared));
  set_where(squared < tiny, along_limb, along_upper);
  set_where(dot(in.way, in.way) < tiny, in.way, along_limb);
  return in;
}

// False if the numbers are not finite, or if `usual` and the limb is not.
template <bool usual, class F>
inline bool solve_limb(LimbProblem<F>& in, LimbSolution<F>& out) {
  const F one = number<F>(kNumbers.one), tiny = number<F>(kNumbers.tiny);
  LimbWays<F>& ways = in.ways;
  Vector<F> squares = squared_lengths(ways.upper, ways.lower, ways.way);
  if (any_below(squares, tiny)) {
    if constexpr (usual) return false;
    F turns;
    ways = with_lengths(ways, turns);
    in.weight = in.partial ? in.weight * turns : turns;
    in.partial = true;
    squares = squared_lengths(ways.upper, ways.lower, ways.way);
  }
  const Vector<F> lengths = roots(squares), inverses = reciprocals<true>(lengths);
  Triangle<F> t;
  t.upper = x_of(lengths), t.lower = y_of(lengths), t.way = z_of(lengths);
  shape_triangle(in, x_of(inverses), t);
  Bend<F> bend;
  if (!bend_limb<usual>(in, ways.upper * x_of(inverses), ways.lower * y_of(inverses), t, bend)) return false;
  const About<F> about = {in.pole, in.twisted, in.twist_rad};
  AnyTurn<F> whole;
  if (!turn_onto<usual>(bend.to_end, bend.normal, ways.way * z_of(inverses), about, whole)) return false;
  Quaternion<F> start = quaternion(axis_to_local(Axes<F>(axes_of<usual>(in.scene_from_start)), whole.axis), whole.w);
  F start_squared = squared_length(start), mid_squared = squared_length(bend.mid);
  if (!all(start_squared + mid_squared + (t.miss_squared + bend.agreed) < number<F>(kNumbers.huge))) return false;
  if (any(lesser(start_squared, mid_squared) < tiny)) {
    if constexpr (usual) return false;
    const auto no_start = start_squared < tiny, no_mid = mid_squared < tiny;
    set_where(no_start, start, unturned<F>());
    set_where(no_start, start_squared, one);
    set_where(no_mid, bend.mid, unturned<F>());
    set_where(no_mid, mid_squared, one);
  }
  out = {start * (one / sqrt(start_squared)), bend.mid * (one / sqrt(mid_squared)), t.stretch, t.miss_squared, t.limb};
  if (in.partial) {
    out.start = weighted_turn(out.start, in.weight);
    out.mid = weighted_turn(out.mid, in.weight);
    out.stretch = one + (t.stretch - one) * in.weight;
  }
  return true;
}

}  // namespace marrow
