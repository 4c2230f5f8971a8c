// A limb of two bones solved, one limb or four at a time: the same operations in the same order, so the same bits.
#pragma once

#include "core/check.h"
#include "ik/turn_onto.h"
#include "marrow/ik.h"

namespace marrow {

// solve_two_bone(), for what does not refuse when it does.
BadCall reach(const Skeleton& skeleton, const TwoBoneLimb& limb, const TwoBone& goal, Span<SoaTransform> local,
              Span<Affine> scene_from_joint, bool* reached);

template <class F>
struct LimbProblem {
  Vector<F> upper, lower, way;                 // scene: start to middle joint, middle to end joint, start to target
  Linear<F> scene_from_start, scene_from_mid;  // rows
  Vector<F> bend_axis;
  About<F> about;
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
  F miss;  // metres
  F limb;  // length, metres
};

// Sine of the bend below which the preferred bend axis has a say.
inline constexpr float kStraight = 0x3p-6f;

// The three lengths, and what the triangle of the bones and the way to the target is to be.
template <class F>
struct Triangle {
  F upper, lower, way;
  F half_cos, half_sin;  // of half the bend at the middle joint, both times any length; 0 is straight
  F along, across;       // cosine and sine of the angle at the start joint
  F stretch, limb, miss;
};

template <class F>
inline void shape_triangle(const LimbProblem<F>& in, F inverse_upper, Triangle<F>& t) {
  const F one = all_lanes<F>(1), half = all_lanes<F>(0.5f);
  const F sum = t.upper + t.lower, difference = t.upper - t.lower, least = absolute(difference);
  F reach = t.way;
  t.stretch = one;
  if (const F firm = in.soft * sum; any(firm < reach)) {
    // sum - e (1 + z / 4)⁻⁴ with e = sum - firm, z = (reach - firm) / e: slope 1, then ever less.
    const F four = all_lanes<F>(4), e = sum - firm, over = greater(reach - firm, all_lanes<F>(0));
    const F g = four * e / (four * e + over), g2 = g * g;
    reach = select(firm < reach, sum - e * g2 * g2, reach);
    if (in.stretched) t.stretch = select(firm < t.way, greater(one, lesser(in.max_stretch, t.way / reach)), one);
  }
  reach = lesser(greater(reach, greater(least, all_lanes<F>(0x1p-20f) * sum)), sum);
  t.half_cos = sqrt((reach - least) * (reach + least));
  t.half_sin = sqrt((sum - reach) * (sum + reach));
  const F inverse = one / reach, scale = half * inverse_upper;
  t.along = scale * (reach + difference * sum * inverse);
  t.across = scale * (t.half_cos * t.half_sin * inverse);
  t.limb = sum;
  t.miss = absolute(reach * t.stretch - t.way);
}

// The bones' plane, and the middle joint's turn that bends them as the triangle says.
template <class F>
struct Bend {
  Vector<F> normal, to_end;  // unit; to_end: from start to end, once bent
  Quaternion<F> mid;         // axis in the middle joint's local space
  F agreed;                  // how far the bend is as preferred: not finite if the preference is not
};

// Where the limb is all but straight, or bent the other way than preferred: the normal is pulled to the preferred axis
// until it has kStraight of it; so it is never without direction, and moves steadily. The lower bone is turned straight
// first, about the normal that it has, then bent about the new one.
template <class F>
inline Bend<F> bend_preferred(const LimbProblem<F>& in, const Axes<F>& mid_axes, const Vector<F>& upper,
                              const Vector<F>& lower, const Triangle<F>& triangle) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1), straight = all_lanes<F>(kStraight);
  const F tiny = all_lanes<F>(kTinySquare), little = all_lanes<F>(1e-6f);
  const Vector<F> now = cross(upper, lower);
  const auto free = dot(in.bend_axis, in.bend_axis) < tiny;
  const Vector<F> wanted = select(free, cross(in.about.pole, upper), axis_to_scene(mid_axes, in.bend_axis));
  const F enough = little * select(free, dot(in.about.pole, in.about.pole), dot(wanted, wanted));
  Vector<F> axis = wanted - upper * dot(wanted, upper);
  const F squared = dot(axis, axis);
  const auto lost = squared < greater(enough, tiny);
  axis = select(lost, any_across(upper), axis * (one / sqrt(select(lost, one, squared))));
  axis = axis - upper * dot(axis, upper);  // again, for what is left if that was nearly all of it
  // now is 2 sin(bend / 2) cos(bend / 2) long, w and u are 2 cos²(bend / 2) and 2 sin²(bend / 2).
  const F cosine = dot(upper, lower), w = one + cosine, u = one - cosine;
  const F agreed = select(free, sqrt(dot(now, now)), dot(now, axis));
  Vector<F> normal = now + axis * greater(straight * w * all_lanes<F>(0.5f) - agreed, zero);
  normal = normal - upper * dot(normal, upper);
  const F normal_squared = dot(normal, normal);
  const auto flat = normal_squared < all_lanes<F>(1e-14f);
  normal = select(flat, axis, normal * (one / sqrt(select(flat, one, normal_squared))));
  // Straightened about `now`, then bent about the normal; if folded, folded more, and opened about the normal.
  const F c = triangle.half_cos, s = triangle.half_sin;
  const Quaternion<F> opened =
      quaternion(normal * (s * w) - now * c - cross(normal, now) * s, c * w + s * dot(normal, now));
  const Quaternion<F> folded =
      quaternion(normal * (c * u) - now * s + cross(normal, now) * c, zero - s * u - c * dot(normal, now));
  const Quaternion<F> turn = select(cosine < zero, folded, opened);
  return {normal, upper * triangle.along + cross(normal, upper) * triangle.across,
          quaternion(axis_to_local(mid_axes, axis_part(turn)), w_of(turn)), agreed};
}

template <bool plain, class F>
inline bool bend_limb(const LimbProblem<F>& in, const Vector<F>& upper, const Vector<F>& lower,
                      const Triangle<F>& triangle, Bend<F>& bend) {
  const F one = all_lanes<F>(1), straight = all_lanes<F>(kStraight);
  const Axes<F> mid_axes = axes_of<plain>(in.scene_from_mid);
  const F cosine = dot(upper, lower);
  const Vector<F> normal = cross(upper, lower), local = without_w(axis_to_local(mid_axes, normal));
  const F sine = sqrt(dot(normal, normal)), inverse = one / sine;
  const F w = one + cosine, c = triangle.half_cos, s = triangle.half_sin, side = triangle.across * inverse;
  bend = {normal * inverse, upper * (triangle.along - side * cosine) + lower * side,
          quaternion(local * (s * w * inverse - c), c * w + s * sine), one};
  F agreed = dot(local, in.bend_axis);
  bend.agreed = agreed;
  if (!all(straight < agreed)) {
    agreed = select(dot(in.bend_axis, in.bend_axis) < all_lanes<F>(kTinySquare), sine, agreed);
    if (const auto bent = straight < agreed; !all(bent)) {
      if constexpr (plain) return false;
      const Bend<F> other = bend_preferred(in, mid_axes, upper, lower, triangle);
      bend = {select(bent, bend.normal, other.normal), select(bent, bend.to_end, other.to_end),
              select(bent, bend.mid, other.mid), agreed};
    }
  }
  return true;
}

// Bones of no length, and a target at the start joint: something that has directions in their place.
template <class F>
inline LimbProblem<F> with_lengths(LimbProblem<F> in) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1), tiny = all_lanes<F>(kTinySquare);
  const Vector<F> none = vector_of(zero, zero, zero);
  const auto no_upper = dot(in.upper, in.upper) < tiny;  // one bone, from the start to the end
  in.upper = select(no_upper, in.lower, in.upper);
  in.lower = select(no_upper, none, in.lower);
  const auto no_limb = dot(in.upper, in.upper) < tiny;  // nothing to turn
  in.upper = select(no_limb, vector_of(one, zero, zero), in.upper);
  in.weight = select(no_limb, zero, in.partial ? in.weight : one);
  in.partial = true;
  const Vector<F> now = in.upper + in.lower;
  const Vector<F> way = select(dot(now, now) < tiny, in.upper, now);
  in.way = select(dot(in.way, in.way) < tiny, way, in.way);
  return in;
}

template <bool plain, class F>
inline bool solve_with(const LimbProblem<F>& in, Triangle<F>& t, F inverse_upper, F inverse_lower, F inverse_way,
                       LimbSolution<F>& out) {
  shape_triangle(in, inverse_upper, t);
  Bend<F> bend;
  if (!bend_limb<plain>(in, in.upper * inverse_upper, in.lower * inverse_lower, t, bend)) return false;
  Quaternion<F> whole;
  if (!turn_onto<plain>(bend.to_end, bend.normal, in.way * inverse_way, in.about, whole)) return false;
  const Quaternion<F> start =
      quaternion(axis_to_local(axes_of<plain>(in.scene_from_start), axis_part(whole)), w_of(whole));
  const F start_squared = squared_length(start), mid_squared = squared_length(bend.mid);
  const F most = start_squared + mid_squared + (t.miss + bend.agreed);
  if (!all(most < all_lanes<F>(kHugeSquare))) return false;
  if (plain && !all(all_lanes<F>(kTinySquare) < lesser(start_squared, mid_squared))) return false;
  out = {unit_turn<plain>(start, start_squared), unit_turn<plain>(bend.mid, mid_squared), t.stretch, t.miss, t.limb};
  if (in.partial) {
    const F one = all_lanes<F>(1);
    const auto some = in.weight < all_lanes<F>(1);
    out.start = select(some, part_of(out.start, in.weight), out.start);
    out.mid = select(some, part_of(out.mid, in.weight), out.mid);
    out.stretch = one + (t.stretch - one) * in.weight;
  }
  return true;
}

// False if the numbers are not finite. If `plain`, what only few limbs need is left out; false also if this one needs
// it.
template <bool plain, class F>
inline bool solve_limb(const LimbProblem<F>& in, LimbSolution<F>& out) {
  const F one = all_lanes<F>(1), tiny = all_lanes<F>(kTinySquare);
  const F upper = dot(in.upper, in.upper), lower = dot(in.lower, in.lower), way = dot(in.way, in.way);
  Triangle<F> t;
  t.upper = sqrt(upper);
  t.lower = sqrt(lower);
  t.way = sqrt(way);
  if constexpr (plain) {
    if (in.about.twisted) return false;
  }
  if (any(lesser(lesser(upper, lower), way) < tiny)) {
    if constexpr (plain) return false;
    const LimbProblem<F> other = with_lengths(in);
    const F other_upper = dot(other.upper, other.upper), other_lower = dot(other.lower, other.lower);
    t.upper = sqrt(other_upper);
    t.lower = sqrt(other_lower);
    const F other_way = dot(other.way, other.way);
    if (!solve_with<false>(other, t, one / t.upper, inverse_root(other_lower), inverse_root(other_way), out))
      return false;
    out.limb = select(upper + lower < tiny, all_lanes<F>(0), out.limb);
    return true;
  }
  return solve_with<plain>(in, t, one / t.upper, one / t.lower, one / t.way, out);
}

}  // namespace marrow
