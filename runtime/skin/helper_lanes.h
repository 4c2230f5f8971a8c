// Helpers that go at once: four, a lane each; or one, whose vectors lie in a register each. The bits are the same.
#pragma once

#include "marrow/file.h"
#include "math/columns.h"
#include "math/rotation.h"

namespace marrow {

// 1 + the trace of a turn by 166°; of what turns farther w is small.
inline constexpr float kFarTurn = 0.0625f;

// A turn as a quaternion of some length, w ≥ 0: the shorter way.
template <class F>
struct HelperTurn {
  Vector<F> v;
  F w, length;
};

[[gnu::cold, gnu::noinline]] inline void take_far_turn(const Linear<f32x4>& m, HelperTurn<f32x4>& out) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f), xx = m.x.x, yy = m.y.y, zz = m.z.z;
  const f32x4 xy = m.x.y + m.y.x, xz = m.x.z + m.z.x, yz = m.y.z + m.z.y;
  const Vector<f32x4> by_x = {one + xx - yy - zz, xy, xz}, by_y = {xy, one + yy - zz - xx, yz},
                      by_z = {xz, yz, one + zz - xx - yy};
  const mask4 y_is_more = xx < yy, z_is_most = greater(xx, yy) < zz, is_far = out.w < splat(kFarTurn);
  const Vector<f32x4> v = select(z_is_most, by_z, select(y_is_more, by_y, by_x));
  const f32x4 w = select(z_is_most, out.v.z, select(y_is_more, out.v.y, out.v.x));
  out.v = select(is_far, select(w < zero, -v, v), out.v);
  out.w = select(is_far, absolute(w), out.w);
  out.length = select(is_far, sqrt(dot(v, v) + w * w), out.length);
}

template <class F>
struct HelperLanes;

template <>
struct HelperLanes<f32x4> {
  static constexpr std::size_t kCount = 4;

  static f32x4 shares(const Helper* h) { return lanes(h[0].share, h[1].share, h[2].share, h[3].share); }
  // Of the palette, or bind matrices. joint: Helper::first or second.
  using Maps = FourAffines;
  template <class Joint>
  static Maps maps(const Affine* from, const Helper* h, Joint joint) {
    return load_affines(from[h[0].*joint], from[h[1].*joint], from[h[2].*joint], from[h[3].*joint]);
  }
  static Linear<f32x4> columns_of(const Maps& m) { return transposed(m.rows); }
  static Vector<f32x4> origin_of(const Maps& m) { return origin(m); }
  static Vector<f32x4> transformed(const Maps& m, const Vector<f32x4>& point) { return transform(m, point); }
  static Vector<f32x4> centres(const float* c) {
    Vector<f32x4> out;
    load_xyz(c, out.x, out.y, out.z);
    return out;
  }
  static Linear<f32x4> transposed(const Linear<f32x4>& m) {
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
  }
  static Linear<f32x4> matrix_of(const Quaternion<f32x4>& q) { return marrow::matrix_of(q); }
  static HelperTurn<f32x4> shorter_turn(const Linear<f32x4>& m) {
    HelperTurn<f32x4> out;
    out.v = {m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
    out.w = splat(1.0f) + (m.x.x + m.y.y + m.z.z);
    out.length = sqrt(splat(4.0f) * out.w);
    if (any(out.w < splat(kFarTurn))) [[unlikely]]
      take_far_turn(m, out);
    return out;
  }
  static f32x4 in_lanes(f32x4 a) { return a; }
  static void store(const Linear<f32x4>& m, const Vector<f32x4>& origin, std::size_t count, Affine* out) {
    store_row({m.x.x, m.y.x, m.z.x}, origin.x, 0, count, out);
    store_row({m.x.y, m.y.y, m.z.y}, origin.y, 1, count, out);
    store_row({m.x.z, m.y.z, m.z.z}, origin.z, 2, count, out);
  }

 private:
  [[gnu::always_inline]] static void store_row(Vector<f32x4> v, f32x4 origin, int row, std::size_t count, Affine* out) {
    transpose(v.x, v.y, v.z, origin);
    marrow::store(out[0].rows[row], v.x);
    if (count > 1) marrow::store(out[1].rows[row], v.y);
    if (count > 2) marrow::store(out[2].rows[row], v.z);
    if (count > 3) marrow::store(out[3].rows[row], origin);
  }
};

template <>
struct HelperLanes<One> {
  static constexpr std::size_t kCount = 1;

  static One shares(const Helper* h) { return all_lanes<One>(h->share); }
  struct Maps {
    Linear<One> linear;
    Vector<One> origin;
  };
  template <class Joint>
  static Maps maps(const Affine* from, const Helper* h, Joint joint) {
    const Columns m = columns(from[h->*joint]);
    return {{{m.axis[0]}, {m.axis[1]}, {m.axis[2]}}, {m.origin}};
  }
  static const Linear<One>& columns_of(const Maps& m) { return m.linear; }
  static Vector<One> origin_of(const Maps& m) { return m.origin; }
  static Vector<One> transformed(const Maps& m, const Vector<One>& point) { return m.linear * point + m.origin; }
  static Vector<One> centres(const float* c) { return {to_f32x4(vector3(c))}; }
  static Linear<One> transposed(const Linear<One>& m) {
    f32x4 x = m.x.v, y = m.y.v, z = m.z.v, none = splat(0.0f);
    transpose(x, y, z, none);
    return {{x}, {y}, {z}};
  }
  // Sums and differences of products, of which each column has one of either and one of the diagonal.
  static Linear<One> matrix_of(Quaternion<One> q) {
    const f32x4 v = q.v, next = rotated_xyz(v), two = splat(2.0f / dot4(v, v)), squares = v * v;
    const f32x4 products = v * next, with_w = reordered<2, 0, 1, 3>(splat_lane<3>(v) * v);
    const f32x4 others = rotated_xyz(squares) + reordered<2, 0, 1, 3>(squares);
    const Linear<One> rows = {
        {splat(1.0f) - two * others}, {two * (products + with_w)}, {reordered<2, 0, 1, 3>(two * (products - with_w))}};
    const Linear<One> m = transposed(rows);
    return {m.x, {reordered<2, 0, 1, 3>(m.y.v)}, {rotated_xyz(m.z.v)}};
  }
  static HelperTurn<One> shorter_turn(const Linear<One>& columns) {
    float m[3][4];
    marrow::store(m[0], columns.x.v);
    marrow::store(m[1], columns.y.v);
    marrow::store(m[2], columns.z.v);
    f32x4 q = scaled_quaternion(m, true);
    float w = w_lane({q}), squared = 4.0f * w;
    if (w < kFarTurn) {
      q = scaled_quaternion(m, false);
      w = w_lane({q});
      q = w < 0.0f ? -q : q;
      w = absolute(w);
      squared = dot4(q, q);
    }
    return {{without_w(q)}, {splat(w)}, {splat(sqrt(squared))}};
  }
  static f32x4 in_lanes(One a) { return a.v; }
  static void store(const Linear<One>& m, Vector<One> origin, std::size_t, Affine* out) {
    f32x4 a = m.x.v, b = m.y.v, c = m.z.v, d = origin.v;
    transpose(a, b, c, d);
    marrow::store(out->rows[0], a);
    marrow::store(out->rows[1], b);
    marrow::store(out->rows[2], c);
  }
};

}  // namespace marrow
