// A limb of two bones solved, one limb or four at a time: the same operations in the same order, so the same bits.
#pragma once

#include "core/check.h"
#include "ik/turn_joint.h"
#include "ik/turn_onto.h"
#include "marrow/ik.h"

namespace marrow {

// solve_two_bone(), for what does not refuse when it does.
BadCall reach(const PosedJoints& pose, const TwoBoneLimb& limb, const TwoBone& goal, bool* reached);

// Three numbers of four goals, or of one, which are read where they are used: there are not enough registers for them.
template <class F>
using GoalVector = std::conditional_t<std::is_same_v<F, One>, const float (&)[3], Vector<F>>;

// Their w may be anything finite.
inline const Vector<f32x4>& in_registers(const Vector<f32x4>& v) {
  return v;
}
inline Vector<One> in_registers(const float (&v)[3]) {
  return {load_aligned(v)};
}

template <class F>
struct LimbProblem {
  Vector<F> upper, lower, way;  // scene: start to middle joint, middle to end joint, start to target
  RowsOf<F> scene_from_start, scene_from_mid;
  GoalVector<F> bend_axis, pole;
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

template <bool>
inline About<f32x4> about(const LimbProblem<f32x4>& in) {
  return {in.pole, in.twisted, in.twist_rad};
}
template <bool plain>
inline About<One> about(const LimbProblem<One>& in) {
  const Vector<One> pole = in_registers(in.pole);
  return {plain ? pole : without_w(pole), in.twisted, in.twist_rad};
}

// The squared lengths of three vectors, as a vector; its w is the third again.
inline Vector<f32x4> squared_lengths(const Vector<f32x4>& a, const Vector<f32x4>& b, const Vector<f32x4>& c) {
  return {dot(a, a), dot(b, b), dot(c, c)};
}
inline Vector<One> squared_lengths(Vector<One> a, Vector<One> b, Vector<One> c) {
  return {three_sums(a.v * a.v, b.v * b.v, c.v * c.v)};
}
// One over each of three numbers: of one limb's at once, of four limbs' where each is used.
struct InversesOfFour {
  const Vector<f32x4>& of;
};
inline InversesOfFour inverses_of(const Vector<f32x4>& v) {
  return {v};
}
inline f32x4 x_of(InversesOfFour i) {
  return number<f32x4>(kNumbers.one) / i.of.x;
}
inline f32x4 y_of(InversesOfFour i) {
  return number<f32x4>(kNumbers.one) / i.of.y;
}
inline f32x4 z_of(InversesOfFour i) {
  return number<f32x4>(kNumbers.one) / i.of.z;
}
inline Vector<One> inverses_of(Vector<One> v) {
  return {number<f32x4>(kNumbers.one) / v.v};
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

// The bones' plane, and the middle joint's turn that bends them as the triangle says.
template <class F>
struct Bend {
  Vector<F> normal, to_end;  // unit; to_end: from start to end, once bent
  Quaternion<F> mid;         // axis in the middle joint's local space
  F agreed;                  // how far the bend is as preferred: not finite if the preference is not
};

// A unit vector across `unit`, next to v; `otherwise` if v, times a number of that size, is none.
template <class F>
inline Vector<F> unit_across(Vector<F> v, Vector<F> unit, F enough, Vector<F> otherwise) {
  const Vector<F> part = across(v, unit);
  const F squared = dot(part, part);
  Vector<F> unit_part = part * inverse_root(squared);
  set_where(squared < enough, unit_part, otherwise);
  return unit_part;
}

// Where the limb is all but straight, or bent the other way than preferred: the normal is pulled to the preferred axis
// until it has kStraight of it; so it is never without direction, and moves steadily. The lower bone is turned straight
// first, about the normal that it has, then bent about the new one; if folded, folded more, and opened.
template <class F>
inline Bend<F> bend_preferred(const LimbProblem<F>& in, const Axes<F>& mid_axes, Vector<F> upper, Vector<F> now, F sine,
                              F cosine, const Triangle<F>& triangle) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one), tiny = number<F>(kNumbers.tiny);
  const Vector<F> bend_axis = without_w(in_registers(in.bend_axis));
  const auto free = dot(bend_axis, bend_axis) < tiny;
  Vector<F> wanted = axis_to_scene(mid_axes, bend_axis);
  set_where(free, wanted, cross(without_w(in_registers(in.pole)), upper));
  const F enough = greater(dot(wanted, wanted) * all_lanes<F>(1e-6f), tiny);
  Vector<F> axis = unit_across(wanted, upper, enough, any_across(upper));
  axis = across(axis, upper);  // again, for what is left if that was nearly all of it
  // now is 2 sin(bend / 2) cos(bend / 2) long, which is `sine`; w is 2 cos²(bend / 2), or if folded -2 sin²(bend / 2).
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

// Leaves out what only some need if `plain`; false if it is needed.
template <bool plain, class F>
inline bool bend_limb(const LimbProblem<F>& in, Vector<F> upper, Vector<F> lower, const Triangle<F>& triangle,
                      Bend<F>& bend) {
  const F one = number<F>(kNumbers.one), straight = number<F>(kNumbers.straight);
  const Axes<F> mid_axes = axes_of<plain>(in.scene_from_mid);
  const Vector<F> normal = cross(upper, lower), local = without_w(axis_to_local(mid_axes, normal));
  const F sine = sqrt(dot(normal, normal)), inverse = one / sine, cosine = dot(upper, lower);
  const F w = one + cosine, c = triangle.half_cos, s = triangle.half_sin, side = triangle.across * inverse;
  bend = {normal * inverse, upper * (triangle.along - side * cosine) + lower * side,
          quaternion_of(local * (s * w * inverse - c), c * w + s * sine), dot(local, in_registers(in.bend_axis))};
  if (!all(straight < bend.agreed)) {
    const Vector<F> bend_axis = without_w(in_registers(in.bend_axis));
    set_where(dot(bend_axis, bend_axis) < number<F>(kNumbers.tiny), bend.agreed, sine);
    if (const auto bent = straight < bend.agreed; !all(bent)) {
      if constexpr (plain) return false;
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

// Bones of no length, and a target at the start joint: something that has directions in their place. Returns what the
// way to the target is to be multiplied by: 0 at the start joint.
template <class F>
inline F give_lengths(LimbProblem<F>& in) {
  const F tiny = number<F>(kNumbers.tiny);
  const auto no_upper = dot(in.upper, in.upper) < tiny;  // one bone, from the start to the end
  set_where(no_upper, in.upper, in.lower);
  set_where(no_upper, in.lower, Vector<F>{});
  const auto no_limb = dot(in.upper, in.upper) < tiny;  // nothing to turn
  if (any(no_limb)) {
    if (!in.partial) in.weight = number<F>(kNumbers.one);
    in.partial = true;
    set_where(no_limb, in.upper, any_across(Vector<F>{}) * all_lanes<F>(0x1p-40f));
    set_where(no_limb, in.weight, all_lanes<F>(0));
  }
  Vector<F> now = in.upper + in.lower;
  set_where(dot(now, now) < tiny, now, in.upper);
  const auto at_start = dot(in.way, in.way) < tiny;
  set_where(at_start, in.way, now);
  return select(at_start, all_lanes<F>(0), number<F>(kNumbers.one));
}

// False if the numbers are not finite. If `plain`, what only few limbs need is left out; false also if this one needs
// it.
template <bool plain, class F>
inline bool solve_limb(LimbProblem<F>& in, LimbSolution<F>& out) {
  const F one = number<F>(kNumbers.one), tiny = number<F>(kNumbers.tiny);
  Vector<F> squares = squared_lengths(in.upper, in.lower, in.way);
  [[maybe_unused]] F far = one;
  if (plain && in.twisted) return false;
  if (any_below(squares, tiny)) {
    if constexpr (plain) return false;
    far = give_lengths(in);
    squares = squared_lengths(in.upper, in.lower, in.way);
  }
  Triangle<F> t;
  const Vector<F> lengths = roots(squares);
  const auto inverses = inverses_of(lengths);
  t.upper = x_of(lengths), t.lower = y_of(lengths), t.way = z_of(lengths);
  if constexpr (!plain) t.way = t.way * far;
  const F inverse_upper = x_of(inverses), inverse_lower = plain ? y_of(inverses) : inverse_root(y_of(squares));
  shape_triangle(in, inverse_upper, t);
  Bend<F> bend;
  if (!bend_limb<plain>(in, in.upper * inverse_upper, in.lower * inverse_lower, t, bend)) return false;
  AnyTurn<F> whole;
  if (!turn_onto<plain>(bend.to_end, bend.normal, in.way * z_of(inverses), about<plain>(in), whole)) return false;
  const Quaternion<F> start = quaternion(axis_to_local(axes_of<plain>(in.scene_from_start), whole.axis), whole.w);
  const F start_squared = squared_length(start), mid_squared = squared_length(bend.mid);
  if (!all(start_squared + mid_squared + (t.miss_squared + bend.agreed) < number<F>(kNumbers.huge))) return false;
  if (plain && any(lesser(start_squared, mid_squared) < tiny)) return false;
  out = {weighted_turn<plain>(start, start_squared, in.partial, in.weight),
         weighted_turn<plain>(bend.mid, mid_squared, in.partial, in.weight), t.stretch, t.miss_squared, t.limb};
  if (in.partial) out.stretch = one + (t.stretch - one) * in.weight;
  return true;
}

}  // namespace marrow
