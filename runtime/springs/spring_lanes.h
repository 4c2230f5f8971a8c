// How many spring bones go at once, and where they lie: four of a SpringGroup, a lane each, or one of them in a
// register where code is to be small. The bits are the same.
#pragma once

#include "math/at_once.h"
#include "math/joint.h"
#include "math/rotation.h"
#include "springs/spring_state.h"

namespace marrow {

template <class F>
struct SpringLanes;

template <>
struct SpringLanes<f32x4> {
  static constexpr int kCount = 4;

  static f32x4 number(const float (&from)[4], int) { return load_aligned(from); }
  static Vector<f32x4> vector(const float (&from)[3][4], int) { return load_vectors(from); }
  static Quaternion<f32x4> rotation(const float (&from)[4][4], int) { return load_rotations(from); }
  static void store(float (&to)[3][4], int, const Vector<f32x4>& v) { store_vectors(to, v); }
  static void store(float (&to)[4][4], int, const Quaternion<f32x4>& q) { store_rotations(to, q); }
  static Vector<f32x4> same(f32x4 v) { return {splat_lane<0>(v), splat_lane<1>(v), splat_lane<2>(v)}; }
  // Of rows of four.
  static Vector<f32x4> rows(const float* const (&row)[4]) {
    f32x4 a = load_aligned(row[0]), b = load_aligned(row[1]), c = load_aligned(row[2]), d = load_aligned(row[3]);
    transpose(a, b, c, d);
    return {a, b, c};
  }
  static Linear<f32x4> linear_rows(const Affine* const (&a)[4]) {
    return marrow::linear_rows(load_affines(*a[0], *a[1], *a[2], *a[3]));
  }
  static Vector<f32x4> vector(const f32x4 (&v)[4]) {
    f32x4 a = v[0], b = v[1], c = v[2], d = v[3];
    transpose(a, b, c, d);
    return {a, b, c};
  }
  static Quaternion<f32x4> quaternion(const f32x4 (&q)[4]) {
    f32x4 a = q[0], b = q[1], c = q[2], d = q[3];
    transpose(a, b, c, d);
    return {a, b, c, d};
  }
  static void split(const Vector<f32x4>& v, f32x4 (&out)[4]) {
    out[0] = v.x, out[1] = v.y, out[2] = v.z, out[3] = splat(0.0f);
    transpose(out[0], out[1], out[2], out[3]);
  }
  static void split(const Quaternion<f32x4>& q, f32x4 (&out)[4]) {
    out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
    transpose(out[0], out[1], out[2], out[3]);
  }
  static void split(f32x4 a, float (&out)[4]) { marrow::store(out, a); }
};

template <>
struct SpringLanes<One> {
  static constexpr int kCount = 1;

  static One number(const float (&from)[4], int lane) { return {splat(from[lane])}; }
  static Vector<One> vector(const float (&from)[3][4], int lane) { return {three_of_lane(&from[0][lane])}; }
  static Quaternion<One> rotation(const float (&from)[4][4], int lane) { return {four_of_lane(&from[0][lane])}; }
  static void store(float (&to)[3][4], int lane, Vector<One> v) { set_three_of_lane(&to[0][lane], v.v); }
  static void store(float (&to)[4][4], int lane, Quaternion<One> q) { set_four_of_lane(&to[0][lane], q.v); }
  static Vector<One> same(f32x4 v) { return {v}; }
  static Vector<One> rows(const float* const (&row)[1]) { return {without_w(load_aligned(row[0]))}; }
  static Linear<One> linear_rows(const Affine* const (&a)[1]) {
    const auto row = [&](int i) { return Vector<One>{without_w(load_aligned(a[0]->rows[i]))}; };
    return {row(0), row(1), row(2)};
  }
  static Vector<One> vector(const f32x4 (&v)[1]) { return {v[0]}; }
  static Quaternion<One> quaternion(const f32x4 (&q)[1]) { return {q[0]}; }
  static void split(Vector<One> v, f32x4 (&out)[1]) { out[0] = v.v; }
  static void split(Quaternion<One> q, f32x4 (&out)[1]) { out[0] = q.v; }
  static void split(One a, float (&out)[1]) { out[0] = first_lane(a.v); }
};

// What there is of four, of one.
inline One inverse_length(One squared) {
  return {inverse_length(squared.v)};
}
inline Vector<One> normalised(Vector<One> v) {
  return v * inverse_length(dot(v, v));
}
inline Vector<One> no_longer(Vector<One> v, float most) {
  const One squared = dot(v, v);
  return first_lane(squared.v) > most * most ? v * (One{splat(most)} * inverse_length(squared)) : v;
}
inline One exp_negative(One x) {
  return {exp_negative(x.v)};
}
inline One two_over_squared(Quaternion<One> q) {
  const float squared = dot4(q.v, q.v);
  return {splat(0.0f < squared ? 2.0f / squared : 0.0f)};
}
inline Vector<One> rotate_by_any(Quaternion<One> q, One two_over_squared, Vector<One> v) {
  const f32x4 t = cross3(q.v, v.v);
  return {v.v + (t * splat_lane<3>(q.v) + cross3(q.v, t)) * two_over_squared.v};
}

using Lanes = SpringLanes<Number>;

}  // namespace marrow
