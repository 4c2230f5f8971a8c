// Quaternions, over a lane: see math/lane.h. Rotations are those of unit length.
#pragma once

#include "marrow/pose.h"
#include "math/elementary.h"
#include "math/linear.h"

namespace marrow {

template <class F>
struct Quaternion {
  F x{}, y{}, z{}, w = all_lanes<F>(1);
};
template <>
struct Quaternion<One> {
  f32x4 v;  // x, y, z, w
};
using Rotation = Quaternion<float>;

inline Rotation rotation(const float* p) {
  return {p[0], p[1], p[2], p[3]};
}
inline void store(float* to, const Rotation& q) {
  to[0] = q.x;
  to[1] = q.y;
  to[2] = q.z;
  to[3] = q.w;
}
// Four at once, as poses have them.
inline Quaternion<f32x4> load_rotations(const float (&from)[4][4]) {
  return {load_aligned(from[0]), load_aligned(from[1]), load_aligned(from[2]), load_aligned(from[3])};
}
inline void store_rotations(float (&to)[4][4], const Quaternion<f32x4>& q) {
  store(to[0], q.x);
  store(to[1], q.y);
  store(to[2], q.z);
  store(to[3], q.w);
}

template <class F>
inline Quaternion<F> quaternion(const Vector<F>& axis, F w) {
  return {axis.x, axis.y, axis.z, w};
}
template <class F>
inline Vector<F> axis_part(const Quaternion<F>& q) {
  return {q.x, q.y, q.z};
}
template <class F>
inline F w_of(const Quaternion<F>& q) {
  return q.w;
}
// Inlined as those of vectors are.
template <class F>
[[gnu::always_inline]] inline Quaternion<F> operator+(const Quaternion<F>& a, const Quaternion<F>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class F>
[[gnu::always_inline]] inline Quaternion<F> operator*(const Quaternion<F>& q, F s) {
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}
template <class F>
[[gnu::always_inline]] inline F dot(const Quaternion<F>& a, const Quaternion<F>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
template <class F>
inline Quaternion<F> select(mask4 m, const Quaternion<F>& yes, const Quaternion<F>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z), select(m, yes.w, no.w)};
}
template <class F>
inline Quaternion<F> select(bool m, const Quaternion<F>& yes, const Quaternion<F>& no) {
  return m ? yes : no;
}
// Summed in the same order as One, so that one limb gives the same bits as four.
inline f32x4 squared_length(const Quaternion<f32x4>& q) {
  return (q.x * q.x + q.y * q.y) + (q.z * q.z + q.w * q.w);
}

// The same of one quaternion in one register.
inline Quaternion<One> quaternion(Vector<One> axis, One w) {
  return {with_w(axis.v, w.v)};
}
inline Vector<One> axis_part(Quaternion<One> q) {
  return {without_w(q.v)};
}
inline One w_of(Quaternion<One> q) {
  return {splat_lane<3>(q.v)};
}
inline Quaternion<One> operator*(Quaternion<One> q, One s) {
  return {q.v * s.v};
}
inline One squared_length(Quaternion<One> q) {
  return {sum_of_lanes(q.v * q.v)};
}

inline Quaternion<One> flip(Quaternion<One> q, One by) {
  return {flip(q.v, by.v)};
}
inline Quaternion<One> select(bool m, Quaternion<One> yes, Quaternion<One> no) {  // as of One
  if (m) return yes;
  return no;
}

// First b, then a.
template <class F>
inline Quaternion<F> operator*(const Quaternion<F>& a, const Quaternion<F>& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
template <class F>
inline Quaternion<F> conjugate(const Quaternion<F>& q) {
  return {-q.x, -q.y, -q.z, q.w};
}
// All four components negated where the sign bit of `by` is set: the same rotation.
template <class F>
inline Quaternion<F> flip(const Quaternion<F>& q, F by) {
  return {flip(q.x, by), flip(q.y, by), flip(q.z, by), flip(q.w, by)};
}

// Of unit length; a quaternion of length 0 stays 0.
inline Quaternion<f32x4> normalised(const Quaternion<f32x4>& q) {
  return q * inverse_length(dot(q, q));
}
// Of unit length; the identity if it is too short, or not finite.
inline Rotation normalised(const Rotation& q) {
  const float squared = dot(q, q);
  return has_direction(squared) ? q * (1.0f / sqrt(squared)) : Rotation{};
}

// v, turned.
inline Vector3 rotate(const Rotation& q, const Vector3& v) {
  const Vector3 t = cross(axis_part(q), v) * 2.0f;
  return v + t * q.w + cross(axis_part(q), t);
}
// v turned by quaternions of any length. A quaternion of length 0 leaves v unchanged.
template <class F>
inline Vector<F> rotate_by_any(const Quaternion<F>& q, F two_over_squared, const Vector<F>& v) {
  const Vector<F> t = cross(axis_part(q), v);
  return v + (t * q.w + cross(axis_part(q), t)) * two_over_squared;
}
inline f32x4 two_over_squared(const Quaternion<f32x4>& q) {
  const f32x4 squared = dot(q, q), zero = splat(0.0f);
  return select(zero < squared, splat(2.0f) / squared, zero);
}

// The axes of a unit rotation: the columns of its matrix.
template <class F>
inline Linear<F> columns_of(const Quaternion<F>& q) {
  const F one = all_lanes<F>(1);
  const F x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const F xx = q.x * x2, yy = q.y * y2, zz = q.z * z2, xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
  const F wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
  return {
      {one - (yy + zz), xy + wz, xz - wy}, {xy - wz, one - (xx + zz), yz + wx}, {xz + wy, yz - wx, one - (xx + yy)}};
}

// A share of a unit rotation, by linear interpolation from the identity; not normalised, as share_of() is. With w ≥ 0
// it goes the shorter way.
template <class F>
inline Quaternion<F> straight_share(const Quaternion<F>& q, F share) {
  return quaternion(axis_part(q) * share, w_of(q) * share + (all_lanes<F>(1) - share));
}
template <class F>
inline Quaternion<F> share_of(const Quaternion<F>& q, F share) {
  return normalised(straight_share(q, share));
}

// The rotation by |v| about v, for |v| ≤ 2π: unit within 1e-6; exactly the identity for 0.
template <class F>
inline Quaternion<F> exp_rotation(const Vector<F>& v) {
  const Vector<F> half = v * all_lanes<F>(0.5f);
  const F y = dot(half, half);
  return quaternion(half * sinc_of_root(y), cos_of_root(y));
}

// Axis times angle of unit quaternions with w > -½√2; the angle is in [0, 3π/2) and off by at most 1e-6 rad. For lower
// w it is the negated logarithm of -q, so callers choose the sign of q first.
template <class F>
inline Vector<F> log_rotation(const Quaternion<F>& q) {
  const F zero = all_lanes<F>(0), two = all_lanes<F>(2), half_pi = all_lanes<F>(1.57079633f);
  const F sine_squared = dot(axis_part(q), axis_part(q));
  const auto narrow = sine_squared < all_lanes<F>(0.5f);  // half the angle is within π/4 of 0; else it is near π/2
  const F w = w_of(q), part = asinc_of_root(select(narrow, sine_squared, w * w));
  const F wide = (half_pi - w * part) * inverse_length(select(narrow, zero, sine_squared));
  return axis_part(q) * (two * select(narrow, part, wide));
}
// The logarithm of q or -q, whichever has w ≥ 0: the shorter turn.
template <class F>
inline Vector<F> log_of_shorter(const Quaternion<F>& q) {
  return log_rotation(flip(q, w_of(q)));
}

}  // namespace marrow
