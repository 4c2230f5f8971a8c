// The parts that reaching and looking share: one direction turned onto another with a say in what turns about it, and a
// turn in the scene brought into a joint's local space.
#pragma once

#include <type_traits>

#include "ik/goals.h"
#include "ik/numbers.h"
#include "math/affine.h"
#include "math/quaternion.h"

namespace marrow {

// Sine of the angle between target and pole below which the pole loses its say.
inline constexpr float kPoleCone = 0.1f;
// There the middle joint goes over to a side of 37° from that of the pose, so that it swings round, and does not jump,
// where the target goes over the pole in the plane of pose and pole.
inline constexpr float kPullAlong = 0.8f, kPullAside = 0.6f;

// The square of a pole's part across the target's direction that is as good as none.
inline constexpr float kNoSide = 8 * kTinySquare;

// The square of the sum of two directions that are as good as opposite.
inline constexpr float kOpposite = 1e-13f;

// to = value, where m holds.
template <class T>
inline void set_where(bool m, T& to, T value) {
  if (m) to = value;
}
template <class T>
inline void set_where(mask4 m, T& to, T value) {
  to = select(m, value, to);
}

alignas(16) inline constexpr float kUnitAxes[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

// A quaternion, of an axis whose w is 0.
template <class F>
inline Quaternion<F> quaternion_of(const Vector<F>& axis, F w) {
  return quaternion(axis, w);
}
inline Quaternion<One> quaternion_of(const Vector<One>& axis, One w) {
  return {axis.v + only_w(w.v)};
}

template <class F>
inline Quaternion<F> unturned() {
  return quaternion(Vector<F>{}, number<F>(kNumbers.one));
}
template <>
inline Quaternion<One> unturned() {
  return {only_w(number<One>(kNumbers.one).v)};
}

// A turn of any length, given squared, to one of length 1: the identity if it has no length. If `plain`, it has.
template <bool plain, class F>
inline Quaternion<F> unit_turn(Quaternion<F> q, F squared) {
  const F one = number<F>(kNumbers.one);
  if constexpr (plain) return q * (one / sqrt(squared));
  Quaternion<F> unit = q * inverse_root(squared);
  set_where(squared < number<F>(kNumbers.tiny), unit, unturned<F>());
  return unit;
}

// As share_of(). With part_where_some(), of four turns those with a weight of 1 stay whole; a single one has less.
template <class F>
inline Quaternion<F> part_of(Quaternion<F> q, F weight) {
  const Quaternion<F> part = straight_share(q, weight);
  return unit_turn<true>(part, squared_length(part));
}
inline Quaternion<f32x4> part_where_some(Quaternion<f32x4> q, f32x4 weight) {
  return select(weight < number<f32x4>(kNumbers.one), part_of(q, weight), q);
}
inline Quaternion<One> part_where_some(Quaternion<One> q, One weight) {
  return part_of(q, weight);
}

// The part by `weight`, if it is `partial`, of a turn as of unit_turn().
template <bool plain, class F>
inline Quaternion<F> weighted_turn(Quaternion<F> q, F squared, bool partial, F weight) {
  const Quaternion<F> whole = unit_turn<plain>(q, squared);
  return partial ? part_where_some(whole, weight) : whole;
}

// A quaternion of any length, in the scene or in local space.
template <class F>
struct AnyTurn {
  Vector<F> axis;
  F w;
};

// What says how things turn about the target's direction.
template <class F>
struct About {
  std::conditional_t<std::is_same_v<F, One>, Vector<F>, const Vector<F>&> pole;  // zero: the shortest arc alone
  bool twisted;
  F twist_rad;  // on top, if twisted
};

// An angle by its cosine and sine, and their length.
template <class F>
struct Angle {
  F cos, sin, length;
};

// The angle less a twist.
inline Angle<One> untwisted(Angle<One> a, One twist_rad) {
  const CosSin twist = cos_sin(first_lane(twist_rad.v));
  const One cos = all_lanes<One>(twist.cos), sin = all_lanes<One>(twist.sin);
  return {a.cos * cos + a.sin * sin, a.sin * cos - a.cos * sin, a.length};
}
inline Angle<f32x4> untwisted(Angle<f32x4> a, f32x4 twist_rad) {
  float angles_rad[4], cosines[4], sines[4];
  store(angles_rad, twist_rad);
  for (int i = 0; i < 4; ++i) {
    const CosSin twist = cos_sin(angles_rad[i]);
    cosines[i] = twist.cos;
    sines[i] = twist.sin;
  }
  const f32x4 cos = load(cosines), sin = load(sines);
  return {a.cos * cos + a.sin * sin, a.sin * cos - a.cos * sin, a.length};
}

// The angle from the pole's side where that is shorter than `cone`, squared, as target and pole are near: pulled to
// beside where the shortest arc leaves it, the more the nearer they are. Where there is no pole, it stays there.
template <class F>
inline Angle<F> pulled(Angle<F> a, F cone) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one), pull = greater(sqrt(cone) - a.length, zero);
  const F c = a.cos + pull * all_lanes<F>(kPullAlong), s = a.sin + pull * all_lanes<F>(kPullAside);
  const F squared = c * c + s * s;
  const auto none = squared < all_lanes<F>(2 * kNoSide);
  Angle<F> to = {c, s, sqrt(squared)};
  set_where(none, to.cos, one);
  set_where(none, to.sin, zero);
  set_where(none, to.length, one);
  return to;
}

// Half-way between two directions, of any length.
template <class F>
struct Halfway {
  Vector<F> h;
  F half, along;  // half of its length squared, and its part along the first of the directions
};
// The same of directions that are far apart, of `h`, their sum: across their difference, which it is but for rounding;
// across the normal if there is nothing left.
template <class F>
inline Halfway<F> halfway_round(Vector<F> from, Vector<F> normal, Vector<F> to, Halfway<F> way) {
  const F half = number<F>(kNumbers.half);
  const Vector<F> apart = from - to;
  const Vector<F> part = way.h - apart * (dot(apart, way.h) / dot(apart, apart));
  const F squared = dot(part, part), inverse = inverse_root(squared);
  const auto far = way.half < number<F>(kNumbers.far), none = squared < all_lanes<F>(kOpposite);
  Halfway<F> out = {part * inverse, half, half * squared * inverse};
  set_where(none, out.h, cross(normal, from));
  set_where(none, out.along, all_lanes<F>(0));
  return {select(far, out.h, way.h), select(far, half, way.half), select(far, out.along, way.along)};
}

// Turns the unit vector `from` onto the unit vector `to`, and then about it: until `normal`, a unit vector across
// `from`, is pole × to; then by the twist. `out` may be of any length, with w ≥ 0. Leaves out what only some need if
// `plain`; false if it is needed.
//
// The shortest arc is half a turn about `from` and one about h, half-way between: q = (from × h, from · h). It takes
// the normal to n - 2 (n · h) h. Both hold for any unit vector h, so that opposites are no exception: there h is in the
// plane of the limb. With C and S the cosine and sine of half the angle that is left, the product is ((from × h) C + h
// S, (from · h) C), with S negative; here h is from + to.
template <bool plain, class F>
inline bool turn_onto(Vector<F> from, Vector<F> normal, Vector<F> to, const About<F>& about, AnyTurn<F>& out) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one);
  Halfway<F> way = {from + to, one, one};
  way.along = way.half = number<F>(kNumbers.half) * dot(way.h, way.h);
  if (any(way.half < number<F>(kNumbers.far))) {
    if constexpr (plain) return false;
    way = halfway_round(from, normal, to, way);
  }
  const Vector<F> carried = normal * way.half - way.h * dot(way.h, normal);
  Angle<F> angle = {one, zero, one};
  if (const F pole = dot(about.pole, about.pole); !all(pole < number<F>(kNumbers.tiny))) {
    angle.cos = dot(about.pole, cross(to, carried));
    angle.sin = dot(about.pole, carried);
    const F squared = angle.cos * angle.cos + angle.sin * angle.sin;
    const F cone =
        greater(pole * (way.half * way.half) * number<F>(kNumbers.cone_squared), number<F>(kNumbers.no_side));
    angle.length = sqrt(squared);
    if (!all(cone < squared)) {
      if constexpr (plain) return false;
      angle = pulled(angle, cone);
    }
  }
  if (!plain && about.twisted) angle = untwisted(angle, about.twist_rad);
  F cos = angle.length + angle.cos, sin = angle.sin;
  if (const auto wide = angle.cos < zero; any(wide)) {  // cos would be a difference of equals
    cos = select(wide, absolute(angle.sin), cos);
    sin = select(wide, flip(angle.length - angle.cos, angle.sin), sin);
  }
  out = {cross(from, way.h) * cos - way.h * sin, way.along * cos};
  return true;
}

// A joint's axes in the scene: the columns of a matrix, which are to be made unit vectors.
template <class F>
struct Axes {
  Linear<F> rows;
  Vector<F> lengths, inverse_lengths;  // their w may be anything
  F handed;                            // its sign: whether they are a right-handed triple; those of flat joints are
};

// 1 / root, of a square that is not 0 if `plain`; else 0 for 0.
template <bool plain>
inline f32x4 reciprocal(f32x4 root, f32x4 squared) {
  const f32x4 inverse = number<f32x4>(kNumbers.one) / root;
  return plain ? inverse : only_where(splat(0.0f) < squared, inverse);
}
template <bool plain>
inline Vector<f32x4> reciprocals(const Vector<f32x4>& roots, const Vector<f32x4>& squared) {
  return {reciprocal<plain>(roots.x, squared.x), reciprocal<plain>(roots.y, squared.y),
          reciprocal<plain>(roots.z, squared.z)};
}
template <bool plain>
inline Vector<One> reciprocals(const Vector<One>& roots, const Vector<One>& squared) {
  return {reciprocal<plain>(roots.v, squared.v)};
}

// The rows of four matrices' linear parts, or a matrix.
template <class F>
using RowsOf = std::conditional_t<std::is_same_v<F, One>, const Affine&, Linear<F>>;

// Axes of no length become 0, or infinite if `plain`.
template <bool plain, class F>
inline Axes<F> axes_of(const Linear<F>& rows) {
  const Vector<F>&x = rows.x, &y = rows.y, &z = rows.z;
  const Vector<F> squared = by_component(x, x) + by_component(y, y) + by_component(z, z), lengths = roots(squared);
  const F volume = dot(cross(x, y), z);
  return {rows, lengths, reciprocals<plain>(lengths, squared), plain ? volume : volume + all_lanes<F>(0)};
}

template <bool plain>
inline Axes<One> axes_of(const Affine& joint) {
  return axes_of<plain>(wide_rows(joint));
}

// A direction, from the scene to the joint's local space, but for its scale; its w may be anything.
template <class F>
inline Vector<F> direction_to_local(const Axes<F>& axes, Vector<F> v) {
  return by_component(axes.rows * v, axes.inverse_lengths);
}
// The axis of a turn.
template <class F>
inline Vector<F> axis_to_local(const Axes<F>& axes, Vector<F> v) {
  return flip(direction_to_local(axes, v), axes.handed);
}
// And back.
template <class F>
inline Vector<F> axis_to_scene(const Axes<F>& axes, Vector<F> v) {
  const Vector<F> t = by_component(v, without_w(axes.inverse_lengths));
  return flip(transposed_times(axes.rows, t), axes.handed);
}

}  // namespace marrow
