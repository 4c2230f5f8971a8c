// 3 × 3 matrices by columns, of numbers F: see math/lane.h. A matrix that is given by rows is handled as its transpose.
#pragma once

#include "math/vector.h"

namespace marrow {

template <class F>
struct Linear {
  Vector<F> x, y, z;  // columns
};

// The same in all lanes.
inline Linear<f32x4> splat(const Linear<float>& m) {
  return {splat(m.x.x, m.x.y, m.x.z), splat(m.y.x, m.y.y, m.y.z), splat(m.z.x, m.z.y, m.z.z)};
}
template <class F>
inline const Vector<F>& column(const Linear<F>& m, std::uint32_t i) {
  return i == 0 ? m.x : i == 1 ? m.y : m.z;
}
template <class F>
inline Vector<F> operator*(const Linear<F>& m, const Vector<F>& v) {
  return m.x * x_of(v) + m.y * y_of(v) + m.z * z_of(v);
}
inline Vector<One> operator*(const Linear<One>& m, Vector<One> v) {
  return m.x * x_of(v) + m.y * y_of(v) + m.z * z_of(v);
}
template <class F>
inline Linear<F> operator*(const Linear<F>& a, const Linear<F>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
// mᵀ v
template <class F>
inline Vector<F> transposed_times(const Linear<F>& m, const Vector<F>& v) {
  return vector_of(dot(m.x, v), dot(m.y, v), dot(m.z, v));
}
inline Vector<One> transposed_times(const Linear<One>& m, Vector<One> v) {
  return {sums(m.x.v * v.v, m.y.v * v.v, m.z.v * v.v)};
}
// aᵀ b
template <class F>
inline Linear<F> transposed_times(const Linear<F>& a, const Linear<F>& b) {
  return {transposed_times(a, b.x), transposed_times(a, b.y), transposed_times(a, b.z)};
}

template <class F>
inline F determinant(const Linear<F>& m) {
  return dot(m.x, cross(m.y, m.z));
}
// The inverse's transpose, times the determinant: dot(m.x, cofactors(m).x).
template <class F>
inline Linear<F> cofactors(const Linear<F>& m) {
  return {cross(m.y, m.z), cross(m.z, m.x), cross(m.x, m.y)};
}

// Gram–Schmidt: x, which is a unit vector; the part of y perpendicular to x, normalised by `unit`; their cross product.
// `unit` also decides what a vector without a direction becomes.
template <class F, class Unit>
inline Linear<F> right_angles(const Vector<F>& x, const Vector<F>& y, const Unit& unit) {
  const Vector<F> second = unit(across(y, x));
  return {x, second, cross(x, second)};
}

}  // namespace marrow
