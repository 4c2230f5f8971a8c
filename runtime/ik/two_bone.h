// The kernel for a limb of two bones: one limb or four at once, with the same bits.
#pragma once

#include "core/check.h"
#include "ik/turn_joint.h"
#include "ik/turn_onto.h"
#include "marrow/ik.h"

namespace marrow {

// solve_two_bone() for callers that refuse in its place: returns what is wrong with the call, or nothing.
BadCall solve_limb_of_pose(const Pose& pose, const TwoBoneLimb& limb, const TwoBone& goal, bool* reached);

// The bones of a limb and the way to its target, in model space.
template <class F>
struct LimbWays {
  Vector<F> upper;  // from the start joint to the middle joint
  Vector<F> lower;  // from the middle joint to the end joint
  Vector<F> way;    // from the start joint to the target
};

template <class F>
struct LimbProblem {
  LimbWays<F> ways;
  RowsOf<F> model_from_start, model_from_mid;
  Vector<F> bend_axis;  // One: w holds something finite
  Vector<F> pole;
  bool twisted;  // some twist is not 0
  F twist_rad;   // read if twisted
  F soft;
  bool stretched;  // some limb may become longer
  F max_stretch;   // read if stretched
  bool partial;    // some weight is below 1
  F weight;        // read if partial
};

template <class F>
struct LimbSolution {
  Quaternion<F> start, mid;
  F stretch;
  F miss_squared;  // squared distance that is left to the target, as at weight 1
  F limb;          // length of the limb
};

// The squared lengths of three vectors. In one register w repeats the third.
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

// The triangle of the two bones and the line between their ends: its lengths now, and its angles as they shall be.
template <class F>
struct Triangle {
  F upper, lower, way;   // lengths; way: to the target
  F half_cos, half_sin;  // of half the bend at the middle joint, both times one length; a straight limb is bent by 0
  F along, across;       // cosine and sine of the angle at the start joint
  F stretch, limb, miss_squared;  // see LimbSolution
};

// Sets the angles by the law of cosines, from the three lengths.
template <class F>
inline void shape_triangle(const LimbProblem<F>& in, F inverse_upper, Triangle<F>& t) {
  const F one = number<F>(kNumbers.one), half = number<F>(kNumbers.half);
  const F sum = t.upper + t.lower, difference = t.upper - t.lower;
  F distance = t.way;  // from the start joint to the end joint, as it shall be
  t.stretch = one;
  if (const F firm = in.soft * sum; any(firm < distance)) {
    // sum - e (1 + z / 4)⁻⁴ with e = sum - firm, z = (distance - firm) / e: slope 1, then ever less.
    const F four = number<F>(kNumbers.four), e = sum - firm, over = greater(distance - firm, all_lanes<F>(0));
    const F g = four * e / (four * e + over), g2 = g * g;
    distance = select(firm < distance, sum - e * g2 * g2, distance);
    if (in.stretched) t.stretch = select(firm < t.way, greater(one, lesser(in.max_stretch, t.way / distance)), one);
  }
  const F folded = greater(difference, t.lower - t.upper);
  distance = lesser(greater(distance, greater(folded, number<F>(kNumbers.least_distance) * sum)), sum);
  t.half_cos = sqrt((distance - difference) * (distance + difference));
  t.half_sin = sqrt((sum - distance) * (sum + distance));
  const F inverse = one / distance, scale = half * inverse_upper;
  t.along = scale * (distance + difference * sum * inverse);
  t.across = scale * (t.half_cos * t.half_sin * inverse);
  t.limb = sum;
  const F miss = (in.stretched ? distance * t.stretch : distance) - t.way;
  t.miss_squared = miss * miss;
}

// The middle joint's turn that gives the bones the triangle's angles.
template <class F>
struct Bend {
  Vector<F> normal;   // unit, across the plane of the bones
  Vector<F> to_end;   // unit, from the start joint to the end joint once bent
  Quaternion<F> mid;  // in the middle joint's space, of any length
  F agreed;           // sine of the bend's part about the preferred axis; not finite: nor is the axis
};

// v's part across `unit`, made a unit vector; `otherwise` where the square of that part is below `enough`.
template <class F>
inline Vector<F> unit_across(Vector<F> v, Vector<F> unit, F enough, Vector<F> otherwise) {
  const Vector<F> part = across(v, unit);
  const F squared = dot(part, part);
  Vector<F> unit_part = part * inverse_root(squared);
  set_where(squared < enough, unit_part, otherwise);
  return unit_part;
}

// Bends a limb that is nearly straight, or bent the wrong way. The preferred axis is mixed into the limb's normal until
// kNumbers.straight of the normal is along it: so the normal always has a direction, and moves steadily. The lower bone
// is first turned straight about the old normal, then bent about the new one. A folded limb is first folded shut.
template <class F>
inline Bend<F> bend_preferred(const LimbProblem<F>& in, const Axes<F>& mid_axes, Vector<F> upper, Vector<F> now, F sine,
                              F cosine, const Triangle<F>& triangle) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one), tiny = number<F>(kNumbers.tiny);
  const Vector<F> bend_axis = without_w(in.bend_axis);
  const auto free = dot(bend_axis, bend_axis) < tiny;
  Vector<F> wanted = axis_to_model(mid_axes, bend_axis);
  set_where(free, wanted, cross(in.pole, upper));
  const F enough = greater(dot(wanted, wanted) * all_lanes<F>(1e-6f), tiny);
  Vector<F> axis = unit_across(wanted, upper, enough, any_across(upper));
  axis = across(axis, upper);  // again: the first part across may be mostly rounding
  // `now`, the normal, is as long as `sine`, 2 sin(bend / 2) cos(bend / 2). w is 2 cos²(bend / 2); -2 sin²(bend / 2) of
  // a folded limb.
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

// Finds the turn of the middle joint. False if `usual` and the limb is nearly straight or bent the wrong way.
template <bool usual, class F>
inline bool bend_limb(const LimbProblem<F>& in, Vector<F> upper, Vector<F> lower, const Triangle<F>& triangle,
                      Bend<F>& bend) {
  const F one = number<F>(kNumbers.one), straight = number<F>(kNumbers.straight);
  const Axes<F> mid_axes = axes_of<usual>(in.model_from_mid);
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

// Gives bones without length a direction and next to no length; so too the way to a target at the start joint.
// turns: 0 where the whole limb has no length and nothing is to be turned, else 1.
template <class F>
inline LimbWays<F> with_lengths(LimbWays<F> in, F& turns) {
  const F tiny = number<F>(kNumbers.tiny), least = all_lanes<F>(0x1p-49f);
  const auto no_upper = dot(in.upper, in.upper) < tiny;  // the lower bone is all there is
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

// Solves one limb or four. False if the numbers are not finite, or if `usual` and some limb needs what is left out.
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
  Quaternion<F> start = quaternion(axis_to_local(Axes<F>(axes_of<usual>(in.model_from_start)), whole.axis), whole.w);
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
