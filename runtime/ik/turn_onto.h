// What limbs and aims share: one direction turned onto another, and turns of model space brought into a joint's space.
//
// F is One for one problem and f32x4 for four of them, a lane each, with the same bits.
//
// A function with `usual` leaves out what few problems need, and returns false for a problem that needs it; callers
// then solve that problem anew without `usual`. Solving it on the way would keep other numbers out of registers: a
// fifth more instructions for everybody.
#pragma once

#include <type_traits>

#include "ik/goals.h"
#include "ik/numbers.h"
#include "math/affine.h"
#include "math/elementary.h"
#include "math/quaternion.h"

namespace marrow {

// Sine of the angle between target and pole below which the pole counts less and less.
inline constexpr float kPoleCone = 0.1f;
// The bend direction that is mixed in there: cosine and sine of 37°, from the side that the shortest arc gives. So a
// target that passes over the pole swings the elbow round and does not flip it.
inline constexpr float kPullAlong = 0.8f, kPullAside = 0.6f;
// Square of a pole's part across the target's direction that counts as none.
inline constexpr float kNoSide = 8 * kTinySquare;
// Square of the sum of two unit vectors that count as opposite.
inline constexpr float kOpposite = 1e-13f;

alignas(16) inline constexpr float kUnitAxes[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

// to = value, where m holds.
template <class T>
inline void set_where(bool m, T& to, T value) {
  if (m) to = value;
}
template <class T>
inline void set_where(mask4 m, T& to, T value) {
  to = select(m, value, to);
}

template <class F>
inline Quaternion<F> unturned() {
  return quaternion(Vector<F>{}, number<F>(kNumbers.one));
}
// The part `weight` of the turn of a unit quaternion.
template <class F>
inline Quaternion<F> weighted_turn(Quaternion<F> q, F weight) {
  const F one = number<F>(kNumbers.one);
  const Quaternion<F> part = straight_share(q, weight);
  set_where(weight < one, q, part * (one / sqrt(squared_length(part))));
  return q;
}

// What fixes the turn about the target's direction.
template <class F>
struct About {
  std::conditional_t<std::is_same_v<F, One>, Vector<F>, const Vector<F>&> pole;  // 0: none, the shortest arc alone
  bool twisted;
  F twist_rad;  // read if twisted; on top of the pole
};

// An angle by its cosine and sine, both times `length`.
template <class F>
struct Angle {
  F cos, sin, length;
};

inline void cosines_and_sines(One angle_rad, One& cos, One& sin) {
  const CosSin of = cos_sin(first_lane(angle_rad.v));
  cos = all_lanes<One>(of.cos), sin = all_lanes<One>(of.sin);
}
inline void cosines_and_sines(f32x4 angle_rad, f32x4& cos, f32x4& sin) {
  float angles_rad[4], cosines[4], sines[4];
  store(angles_rad, angle_rad);
  for (int i = 0; i < 4; ++i) {
    const CosSin of = cos_sin(angles_rad[i]);
    cosines[i] = of.cos, sines[i] = of.sin;
  }
  cos = load(cosines), sin = load(sines);
}

// The angle less a twist.
template <class F>
inline Angle<F> untwisted(Angle<F> a, F twist_rad) {
  F cos, sin;
  cosines_and_sines(twist_rad, cos, sin);
  return {a.cos * cos + a.sin * sin, a.sin * cos - a.cos * sin, a.length};
}

// The angle to the pole's side, where its length is below √cone as target and pole are near each other: mixed with the
// angle of kPullAlong and kPullAside, the more the nearer they are. 0 where there is no pole.
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

// A direction half way between two others.
template <class F>
struct Halfway {
  Vector<F> h;  // of any length
  F half;       // half of its squared length
  F along;      // its part along the first direction
};
// The same for directions that are far apart. Their sum way.h is short, and rounding may leave it off the middle: its
// part along their difference is taken off. Opposite directions get one across the normal.
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

// A quaternion of any length, in model space or in a joint's space.
template <class F>
struct AnyTurn {
  Vector<F> axis;
  F w;  // ≥ 0
};

// Turns the unit vector `from` onto the unit vector `to`; then about `to`, until `normal`, a unit vector across `from`,
// is along pole × to; then by the twist.
//
// The shortest arc is half a turn about `from` and another about h, half way between them: q = (from × h, from · h). It
// takes the normal n to n - 2 (n · h) h. Both are true for every unit vector h half way between opposite directions, so
// these are no exception; their h lies in the plane of the limb. With C and S the cosine and sine of half the angle
// that is left, the whole turn is ((from × h) C + h S, (from · h) C), with S negative. h is from + to here, not a unit
// vector.
template <bool usual, class F>
inline bool turn_onto(Vector<F> from, Vector<F> normal, Vector<F> to, const About<F>& about, AnyTurn<F>& out) {
  const F zero = all_lanes<F>(0), one = number<F>(kNumbers.one);
  Halfway<F> way = {from + to, one, one};
  way.along = way.half = number<F>(kNumbers.half) * dot(way.h, way.h);
  if (any(way.half < number<F>(kNumbers.far))) {
    if constexpr (usual) return false;
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
      if constexpr (usual) return false;
      angle = pulled(angle, cone);
    }
  }
  if (about.twisted) {
    if constexpr (usual) return false;
    angle = untwisted(angle, about.twist_rad);
  }
  F cos = angle.length + angle.cos, sin = angle.sin;
  if (const auto wide = angle.cos < zero; any(wide)) {  // cos would be a difference of equals
    cos = select(wide, absolute(angle.sin), cos);
    sin = select(wide, flip(angle.length - angle.cos, angle.sin), sin);
  }
  out = {cross(from, way.h) * cos - way.h * sin, way.along * cos};
  return true;
}

// A joint's axes in model space, the columns of its matrix, with what makes them unit vectors.
template <class F>
struct Axes {
  Linear<F> rows;
  Vector<F> lengths, inverse_lengths;  // the inverse of 0 is 0, or infinite if `usual`. Ignore their w
  F handed;                            // negative if the axes are a left-handed triple
};

// The linear parts of four matrices, by rows; or one matrix.
template <class F>
using RowsOf = std::conditional_t<std::is_same_v<F, One>, const Affine&, Linear<F>>;

template <bool usual>
inline f32x4 reciprocal(f32x4 root) {
  const f32x4 inverse = number<f32x4>(kNumbers.one) / root;
  return usual ? inverse : only_where(splat(0.0f) < root, inverse);
}
template <bool usual>
inline Vector<f32x4> reciprocals(const Vector<f32x4>& roots) {
  return {reciprocal<usual>(roots.x), reciprocal<usual>(roots.y), reciprocal<usual>(roots.z)};
}
template <bool usual>
inline Vector<One> reciprocals(Vector<One> roots) {
  return {reciprocal<usual>(roots.v)};
}

template <bool usual, class F>
inline Axes<F> axes_of(const Linear<F>& rows) {
  const Vector<F>&x = rows.x, &y = rows.y, &z = rows.z;
  const Vector<F> lengths = roots(by_component(x, x) + by_component(y, y) + by_component(z, z));
  const F volume = dot(cross(x, y), z);
  return {rows, lengths, reciprocals<usual>(lengths), usual ? volume : volume + all_lanes<F>(0)};  // flat: 0, not -0
}
template <bool usual>
inline Axes<One> axes_of(const Affine& joint) {
  return axes_of<usual>(wide_rows(joint));
}

// A direction of model space in the joint's space without its scale. Ignore its w.
template <class F>
inline Vector<F> direction_to_local(const Axes<F>& axes, Vector<F> v) {
  return by_component(axes.rows * v, axes.inverse_lengths);
}
// The axis of a turn likewise: where the axes are left-handed, the turn goes the other way round.
template <class F>
inline Vector<F> axis_to_local(const Axes<F>& axes, Vector<F> v) {
  return flip(direction_to_local(axes, v), axes.handed);
}
// The axis of a turn, from the joint's space to model space.
template <class F>
inline Vector<F> axis_to_model(const Axes<F>& axes, Vector<F> v) {
  const Vector<F> t = by_component(v, without_w(axes.inverse_lengths));
  return flip(transposed_times(axes.rows, t), axes.handed);
}

}  // namespace marrow
