// One problem or four at a time, by one text: F is One, a number that fills all four lanes, or f32x4, a number a lane.
// Vectors and turns of One lie in one register each, those of f32x4 in one a component. The operations and their order
// are the same, and so are the results, but for the sign of zeros.
#pragma once

#include "math/lane.h"

namespace marrow {

template <class F>
struct Vector {
  F x, y, z;
};
template <>
struct Vector<One> {
  f32x4 v;  // x, y, z, 0
};

inline Vector<f32x4> operator+(const Vector<f32x4>& a, const Vector<f32x4>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector<f32x4> operator-(const Vector<f32x4>& a, const Vector<f32x4>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector<f32x4> operator*(const Vector<f32x4>& a, f32x4 s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vector<f32x4> by_component(const Vector<f32x4>& a, const Vector<f32x4>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline f32x4 dot(const Vector<f32x4>& a, const Vector<f32x4>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector<f32x4> cross(const Vector<f32x4>& a, const Vector<f32x4>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// 1 / root; 0 for what is too short.
inline f32x4 inverse_root(f32x4 squared) {
  return only_where(splat(0x1p-100f) < squared, splat(1.0f) / sqrt(squared));
}
inline Vector<f32x4> roots(const Vector<f32x4>& squared) {
  return {sqrt(squared.x), sqrt(squared.y), sqrt(squared.z)};
}
// Component by component; infinite for 0 if `plain`.
template <bool plain>
inline f32x4 inverse_root(f32x4 squared) {
  return plain ? splat(1.0f) / sqrt(squared) : inverse_root(squared);
}
template <bool plain>
inline Vector<f32x4> inverse_roots(const Vector<f32x4>& squared) {
  return {inverse_root<plain>(squared.x), inverse_root<plain>(squared.y), inverse_root<plain>(squared.z)};
}
inline Vector<f32x4> select(mask4 m, const Vector<f32x4>& yes, const Vector<f32x4>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
inline Vector<f32x4> flip(const Vector<f32x4>& a, f32x4 by) {
  return {flip(a.x, by), flip(a.y, by), flip(a.z, by)};
}
inline f32x4 x_of(const Vector<f32x4>& a) {
  return a.x;
}
inline f32x4 y_of(const Vector<f32x4>& a) {
  return a.y;
}
inline f32x4 z_of(const Vector<f32x4>& a) {
  return a.z;
}
inline Vector<f32x4> vector_of(f32x4 x, f32x4 y, f32x4 z) {
  return {x, y, z};
}

inline Vector<One> operator+(const Vector<One>& a, const Vector<One>& b) {
  return {a.v + b.v};
}
inline Vector<One> operator-(const Vector<One>& a, const Vector<One>& b) {
  return {a.v - b.v};
}
inline Vector<One> operator*(const Vector<One>& a, One s) {
  return {a.v * s.v};
}
inline Vector<One> by_component(const Vector<One>& a, const Vector<One>& b) {
  return {a.v * b.v};
}
inline One dot(const Vector<One>& a, const Vector<One>& b) {
  return {sum_of_lanes(a.v * b.v)};
}
inline Vector<One> cross(const Vector<One>& a, const Vector<One>& b) {
  return {rotated_xyz(a.v * rotated_xyz(b.v) - rotated_xyz(a.v) * b.v)};
}
inline One inverse_root(One squared) {
  return {inverse_root(squared.v)};
}
inline Vector<One> roots(const Vector<One>& squared) {
  return {sqrt(squared.v)};
}
template <bool plain>
inline Vector<One> inverse_roots(const Vector<One>& squared) {
  return {inverse_root<plain>(squared.v)};
}
inline Vector<One> select(bool m, const Vector<One>& yes, const Vector<One>& no) {
  return m ? yes : no;
}
inline Vector<One> flip(const Vector<One>& a, One by) {
  return {flip(a.v, by.v)};
}
inline Vector<One> without_w(const Vector<One>& a) {
  return {without_w(a.v)};
}
inline Vector<f32x4> without_w(const Vector<f32x4>& a) {
  return a;
}
inline One x_of(const Vector<One>& a) {
  return {splat_lane<0>(a.v)};
}
inline One y_of(const Vector<One>& a) {
  return {splat_lane<1>(a.v)};
}
inline One z_of(const Vector<One>& a) {
  return {splat_lane<2>(a.v)};
}
inline Vector<One> vector_of(One x, One y, One z) {
  f32x4 a = x.v, b = y.v, c = z.v, d = splat(0.0f);
  transpose(a, b, c, d);
  return {a};
}

// A quaternion, of any length: x, y, z and w.
template <class F>
struct Turn {
  Vector<F> axis;
  F w;
};
template <>
struct Turn<One> {
  f32x4 v;  // x, y, z, w
};

inline Turn<f32x4> turn_of(const Vector<f32x4>& axis, f32x4 w) {
  return {axis, w};
}
inline Turn<f32x4> operator*(const Turn<f32x4>& q, f32x4 s) {
  return {q.axis * s, q.w * s};
}
inline f32x4 squared_length(const Turn<f32x4>& q) {
  return (q.axis.x * q.axis.x + q.axis.y * q.axis.y) + (q.axis.z * q.axis.z + q.w * q.w);
}
inline Turn<f32x4> select(mask4 m, const Turn<f32x4>& yes, const Turn<f32x4>& no) {
  return {select(m, yes.axis, no.axis), select(m, yes.w, no.w)};
}
inline f32x4 w_of(const Turn<f32x4>& q) {
  return q.w;
}
inline Vector<f32x4> axis_of(const Turn<f32x4>& q) {
  return q.axis;
}

inline Turn<One> turn_of(const Vector<One>& axis, One w) {
  return {with_w(axis.v, w.v)};
}
inline Turn<One> operator*(const Turn<One>& q, One s) {
  return {q.v * s.v};
}
inline One squared_length(const Turn<One>& q) {
  return {sum_of_lanes(q.v * q.v)};
}
inline Turn<One> select(bool m, const Turn<One>& yes, const Turn<One>& no) {
  return m ? yes : no;
}
inline One w_of(const Turn<One>& q) {
  return {splat_lane<3>(q.v)};
}
inline Vector<One> axis_of(const Turn<One>& q) {
  return {without_w(q.v)};
}

// The rows of a matrix of three by three.
template <class F>
struct Linear {
  Vector<F> rows[3];
};

}  // namespace marrow
