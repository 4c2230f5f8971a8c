// The parts that reaching and looking share: one direction turned onto another with a say in what turns about it, and a
// turn in the scene brought into a joint's local space.
#pragma once

#include "math/affine.h"
#include "math/quaternion.h"

namespace marrow {

// Of what is as good as infinite. Of few bits, as kTinySquare.
inline constexpr float kHugeSquare = 0x1p+100f;

// Sine of the angle between target and pole below which the pole loses its say.
inline constexpr float kPoleCone = 0.1f;

// A turn of any length, given squared, to one of length 1 with w ≥ 0, or the identity if it has no length. If `plain`,
// it has, and w ≥ 0 already.
template <bool plain, class F>
inline Quaternion<F> unit_turn(const Quaternion<F>& q, F squared) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1), factor = one / sqrt(squared);
  if constexpr (plain) return q * factor;
  const auto none = squared < all_lanes<F>(kTinySquare);
  const Quaternion<F> unit = q * flip(factor, w_of(q));
  return any(none) ? select(none, quaternion(vector_of(zero, zero, zero), one), unit) : unit;
}

// As share_of().
template <class F>
inline Quaternion<F> part_of(const Quaternion<F>& q, F weight) {
  const Quaternion<F> part = straight_share(q, weight);
  return unit_turn<true>(part, squared_length(part));
}

// What says how things turn about the target's direction.
template <class F>
struct About {
  Vector<F> pole;  // zero: the shortest arc alone
  bool twisted;
  F cos, sin;  // of a twist on top, if twisted
};

// Cosine and sine of half an angle, both times any factor.
template <class F>
struct HalfAngle {
  F cos, sin;
};

// The angle about `to`, a unit vector, back from pole × to (and the twist) to `carried`, a vector across it of length
// d. by_arc: where the shortest arc leaves the normal, of any length. Leaves out what only poles near the target need
// if `plain`; false if it is needed.
template <bool plain, class F>
inline bool half_angle_to_pole(const Vector<F>& carried, F d, const Vector<F>& to, const Vector<F>& by_arc,
                               const About<F>& about, HalfAngle<F>& half) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1);
  F c = dot(about.pole, cross(to, carried)), s = dot(about.pole, carried);
  const F squared = c * c + s * s, pole = dot(about.pole, about.pole);
  F length = sqrt(squared);
  if (const auto clear = d * d * pole * all_lanes<F>(kPoleCone * kPoleCone) < squared; !all(clear)) {
    if constexpr (plain) return false;
    // Pulled to where the shortest arc leaves it, the more the nearer target and pole are.
    const F arc_squared = dot(by_arc, by_arc), pull = all_lanes<F>(kPoleCone) * d * sqrt(pole) - length;
    const auto lost = arc_squared < all_lanes<F>(1e-12f);
    const F share = pull / select(lost, one, sqrt(arc_squared) * d);
    const F pulled_c = c + select(lost, pull, share * dot(by_arc, carried));
    const F pulled_s = s - select(lost, zero, share * dot(by_arc, cross(to, carried)));
    const F again = pulled_c * pulled_c + pulled_s * pulled_s;
    const auto none = again < all_lanes<F>(kTinySquare) * d * d;
    c = select(clear, c, select(none, one, pulled_c));
    s = select(clear, s, select(none, zero, pulled_s));
    length = select(clear, length, select(none, one, sqrt(again)));
  }
  if (!plain && about.twisted) {
    const F before = c;
    c = before * about.cos + s * about.sin;
    s = s * about.cos - before * about.sin;
  }
  half = {length + c, s};
  if (const auto wide = c < zero; any(wide)) {  // half.cos would be a difference of equals
    half.cos = select(wide, absolute(s), half.cos);
    half.sin = select(wide, flip(length - c, s), half.sin);
  }
  return true;
}

// Turns the unit vector `from` onto the unit vector `to`, and then about it: until `normal`, a unit vector across
// `from`, is pole × to; then by the twist. `out` is not of unit length. Leaves out what only some need if `plain`;
// false if it is needed.
//
// The shortest arc is q = (d, from × to) with d = 1 + from · to, and takes the normal to n d - (from + to)(n · to),
// over d. With C and S the cosine and sine of half the angle that is left, the product is (d C, (from × to) C + (from +
// to) S), with S negative. If from and to are far apart and there is a pole, half a turn about the normal comes first,
// and what is left is short; without a pole, opposites are half a turn about the normal apart.
template <bool plain, class F>
inline bool turn_onto(const Vector<F>& from, const Vector<F>& normal, const Vector<F>& to, const About<F>& about,
                      Quaternion<F>& out) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1), far = all_lanes<F>(-0.5f);
  const F along = dot(from, to);
  const auto behind = along < far;
  auto back = behind;
  Vector<F> start = from;
  if (any(behind)) {
    if constexpr (plain) return false;
    back = select(all_lanes<F>(kTinySquare) < dot(about.pole, about.pole), along, zero) < far;
    start = select(back, from * (zero - one), from);
  }
  const Vector<F> arc = cross(start, to), sum = start + to;
  F d = one + along;
  if (!plain && any(behind)) d = select(back, one - along, select(behind, dot(arc, arc) / (one - along), d));
  const Vector<F> carried = normal * d - sum * dot(to, normal);
  HalfAngle<F> half = {one + one, zero};
  if (plain && all(dot(about.pole, about.pole) < all_lanes<F>(kTinySquare))) {
    out = quaternion(arc * half.cos, d * half.cos);
    return true;
  }
  Vector<F> by_arc = carried;
  if (!plain && any(behind)) by_arc = select(back, normal * (one + along) - (from + to) * dot(to, normal), carried);
  if (!half_angle_to_pole<plain>(carried, d, to, by_arc, about, half)) return false;
  const Vector<F> axis = arc * half.cos - sum * half.sin;
  const F w = d * half.cos;
  out = quaternion(axis, w);
  if (!plain && any(behind)) {
    const Quaternion<F> whole = quaternion(normal * w + cross(axis, normal), zero - dot(axis, normal));
    out = select(d < all_lanes<F>(1e-14f), quaternion(normal, zero), select(back, whole, out));
  }
  return true;
}

// A joint's axes in the scene: the columns of a matrix, which are to be made unit vectors.
template <class F>
struct Axes {
  Linear<F> rows;
  Vector<F> lengths, inverse_lengths;  // their w may be anything
  F handed;                            // its sign: whether they are a right-handed triple
};

// Axes of no length become 0, or infinite if `plain`.
template <bool plain, class F>
inline Axes<F> axes_of(const Linear<F>& rows) {
  const Vector<F>&x = rows.x, &y = rows.y, &z = rows.z;
  const Vector<F> squared = by_component(x, x) + by_component(y, y) + by_component(z, z);
  return {rows, roots(squared), inverse_roots<plain>(squared), dot(cross(x, y), z)};
}

// A direction, from the scene to the joint's local space, but for its scale; its w may be anything.
template <class F>
inline Vector<F> direction_to_local(const Axes<F>& axes, const Vector<F>& v) {
  return by_component(axes.rows * v, axes.inverse_lengths);
}
// The axis of a turn.
template <class F>
inline Vector<F> axis_to_local(const Axes<F>& axes, const Vector<F>& v) {
  return flip(direction_to_local(axes, v), axes.handed);
}
// And back.
template <class F>
inline Vector<F> axis_to_scene(const Axes<F>& axes, const Vector<F>& v) {
  const Vector<F> t = by_component(v, without_w(axes.inverse_lengths));
  return flip(transposed_times(axes.rows, t), axes.handed);
}

}  // namespace marrow
