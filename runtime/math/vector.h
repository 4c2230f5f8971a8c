// Vectors of three numbers, over a lane: see math/lane.h.
#pragma once

#include "math/finite.h"
#include "math/lane.h"

namespace marrow {

// Vectors whose squared length is below this have no direction. It has few bits: some processors need no load for it.
inline constexpr float kTinySquare = 0x1p-100f;

template <class F>
struct Vector {
  F x{}, y{}, z{};
};
template <>
struct Vector<One> {
  f32x4 v;  // x, y, z, 0
};
using Vector3 = Vector<float>;

inline Vector3 vector3(const float* p) {
  return {p[0], p[1], p[2]};
}
inline void store(float* to, const Vector3& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}
// Four at once, as poses have them.
inline Vector<f32x4> load_vectors(const float (&from)[3][4]) {
  return {load_aligned(from[0]), load_aligned(from[1]), load_aligned(from[2])};
}
inline void store_vectors(float (&to)[3][4], const Vector<f32x4>& v) {
  store(to[0], v.x);
  store(to[1], v.y);
  store(to[2], v.z);
}
inline Vector<f32x4> splat(float x, float y, float z) {
  return {splat(x), splat(y), splat(z)};
}

// Always inlined: at -Os a call, which passes vectors through memory, takes more bytes.
template <class F>
[[gnu::always_inline]] inline Vector<F> operator+(const Vector<F>& a, const Vector<F>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class F>
[[gnu::always_inline]] inline Vector<F> operator-(const Vector<F>& a, const Vector<F>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class F>
[[gnu::always_inline]] inline Vector<F> operator-(const Vector<F>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class F>
[[gnu::always_inline]] inline Vector<F> operator*(const Vector<F>& a, F s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class F>
inline Vector<F> operator/(const Vector<F>& a, F s) {
  return {a.x / s, a.y / s, a.z / s};
}
template <class F>
inline Vector<F> by_component(const Vector<F>& a, const Vector<F>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class F>
[[gnu::always_inline]] inline F dot(const Vector<F>& a, const Vector<F>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class F>
[[gnu::always_inline]] inline Vector<F> cross(const Vector<F>& a, const Vector<F>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F>
[[gnu::always_inline]] inline Vector<F> select(mask4 m, const Vector<F>& yes, const Vector<F>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
template <class F>
inline Vector<F> select(bool m, const Vector<F>& yes, const Vector<F>& no) {
  return m ? yes : no;
}
[[gnu::always_inline]] inline Vector<f32x4> only_where(mask4 m, const Vector<f32x4>& a) {
  return {only_where(m, a.x), only_where(m, a.y), only_where(m, a.z)};
}
template <class F>
inline Vector<F> flip(const Vector<F>& a, F by) {
  return {flip(a.x, by), flip(a.y, by), flip(a.z, by)};
}
template <class F>
inline Vector<F> roots(const Vector<F>& squared) {
  return {sqrt(squared.x), sqrt(squared.y), sqrt(squared.z)};
}
// 1 / √, lane by lane. plain: infinite for 0. Otherwise 0 for squares up to kTinySquare.
template <bool plain>
inline f32x4 inverse_root(f32x4 squared) {
  return plain ? splat(1.0f) / sqrt(squared) : only_where(splat(kTinySquare) < squared, splat(1.0f) / sqrt(squared));
}
template <class F>
inline F x_of(const Vector<F>& a) {
  return a.x;
}
template <class F>
inline F y_of(const Vector<F>& a) {
  return a.y;
}
template <class F>
inline F z_of(const Vector<F>& a) {
  return a.z;
}
template <class F>
inline Vector<F> vector_of(F x, F y, F z) {
  return {x, y, z};
}
inline Vector<f32x4> without_w(const Vector<f32x4>& a) {
  return a;
}

// The same of one vector in one register.
inline Vector<One> operator+(Vector<One> a, Vector<One> b) {
  return {a.v + b.v};
}
inline Vector<One> operator-(Vector<One> a, Vector<One> b) {
  return {a.v - b.v};
}
inline Vector<One> operator*(Vector<One> a, One s) {
  return {a.v * s.v};
}
inline Vector<One> by_component(Vector<One> a, Vector<One> b) {
  return {a.v * b.v};
}
inline One dot(Vector<One> a, Vector<One> b) {
  return {sum_of_lanes(a.v * b.v)};
}
inline Vector<One> cross(Vector<One> a, Vector<One> b) {
  return {rotated_xyz(a.v * rotated_xyz(b.v) - rotated_xyz(a.v) * b.v)};
}
[[gnu::always_inline]] inline Vector<One> select(bool m, Vector<One> yes, Vector<One> no) {  // see One's
  if (m) return yes;
  return no;
}
inline Vector<One> only_where(bool m, Vector<One> a) {
  return {m ? a.v : splat(0.0f)};
}
inline Vector<One> flip(Vector<One> a, One by) {
  return {flip(a.v, by.v)};
}
inline Vector<One> roots(Vector<One> squared) {
  return {sqrt(squared.v)};
}
template <bool plain>
inline One inverse_root(One squared) {
  return {inverse_root<plain>(squared.v)};
}
inline One x_of(Vector<One> a) {
  return {splat_lane<0>(a.v)};
}
inline One y_of(Vector<One> a) {
  return {splat_lane<1>(a.v)};
}
inline One z_of(Vector<One> a) {
  return {splat_lane<2>(a.v)};
}
inline Vector<One> vector_of(One x, One y, One z) {
  f32x4 a = x.v, b = y.v, c = z.v, d = splat(0.0f);
  transpose(a, b, c, d);
  return {a};
}
inline Vector<One> without_w(Vector<One> a) {
  return {without_w(a.v)};
}

template <class F>
inline F inverse_root(F squared) {
  return inverse_root<false>(squared);
}

// The part of v perpendicular to a unit vector.
template <class F>
inline Vector<F> across(const Vector<F>& v, const Vector<F>& unit) {
  return v - unit * dot(v, unit);
}

// A vector perpendicular to v, for v of any length: v × the axis of its smallest component.
template <class F>
inline Vector<F> across_least_axis(const Vector<F>& v) {
  const F zero = all_lanes<F>(0), x = x_of(v), y = y_of(v), z = z_of(v), xx = x * x, yy = y * y, zz = z * z;
  const Vector<F> by_x = vector_of(zero, z, zero - y), by_y = vector_of(zero - z, zero, x),
                  by_z = vector_of(y, zero - x, zero);
  return select(lesser(yy, zz) < xx, select(zz < yy, by_z, by_y), by_x);
}
// The same of unit length; x where v has no direction.
template <class F>
inline Vector<F> any_across(const Vector<F>& v) {
  const F zero = all_lanes<F>(0), one = all_lanes<F>(1);
  const Vector<F> across = across_least_axis(v);
  const F squared = dot(across, across);
  const auto none = squared < all_lanes<F>(kTinySquare);
  return select(none, vector_of(one, zero, zero), across * (one / sqrt(select(none, one, squared))));
}

// In little code: the axes lie in memory.
inline Vector<One> any_across(Vector<One> v) {
  alignas(16) static constexpr float kAxes[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  float squares[4];
  store(squares, v.v * v.v);
  int least = squares[2] < squares[1] ? 2 : 1;
  if (!(squares[least] < squares[0])) least = 0;
  const Vector<One> across = cross(v, {load_aligned(kAxes[least])});
  const One squared = dot(across, across);
  if (squared < all_lanes<One>(kTinySquare)) return {load_aligned(kAxes[0])};
  return across * inverse_root(squared);
}

inline float length(const Vector3& a) {
  return sqrt(dot(a, a));
}
inline bool is_finite(const Vector3& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
inline bool within(const Vector3& v, float least, float most) {
  return within(v.x, least, most) && within(v.y, least, most) && within(v.z, least, most);
}

// Of unit length; a vector of length 0 stays 0.
inline Vector<f32x4> normalised(const Vector<f32x4>& v) {
  return v * inverse_length(dot(v, v));
}
// Of unit length; `otherwise` if it is too short to have a direction, or not finite.
inline Vector3 normalised_or(const Vector3& v, const Vector3& otherwise) {
  const float squared = dot(v, v);
  return has_direction(squared) ? v * (1.0f / sqrt(squared)) : otherwise;
}

// v, no longer than `most`.
inline Vector<f32x4> no_longer(const Vector<f32x4>& v, float most) {
  const f32x4 squared = dot(v, v), limit = splat(most * most);
  return v * select(limit < squared, splat(most) * inverse_length(squared), splat(1.0f));
}

}  // namespace marrow
