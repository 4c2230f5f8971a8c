// Four quaternions at once, and the exponential and the logarithm that turn rotation vectors (axis times angle) into
// them and back. Polynomials instead of a library's trigonometry: the same bits everywhere.
#pragma once

#include "marrow/pose.h"
#include "math/elementary.h"

namespace marrow {

struct Quaternions {
  f32x4 x, y, z, w;
};

struct Vectors {
  f32x4 x, y, z;
};

inline Quaternions load_rotations(const SoaTransform& t) {
  return {load_aligned(t.rotation[0]), load_aligned(t.rotation[1]), load_aligned(t.rotation[2]),
          load_aligned(t.rotation[3])};
}
inline void store_rotations(SoaTransform& t, const Quaternions& q) {
  store(t.rotation[0], q.x);
  store(t.rotation[1], q.y);
  store(t.rotation[2], q.z);
  store(t.rotation[3], q.w);
}

inline Quaternions conjugate(const Quaternions& q) {
  const f32x4 minus = splat(-0.0f);
  return {flip(q.x, minus), flip(q.y, minus), flip(q.z, minus), q.w};
}

// First b, then a.
inline Quaternions operator*(const Quaternions& a, const Quaternions& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

inline f32x4 dot(const Quaternions& a, const Quaternions& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

inline Quaternions scaled(const Quaternions& q, f32x4 factor) {
  return {q.x * factor, q.y * factor, q.z * factor, q.w * factor};
}

inline Quaternions normalised(const Quaternions& q) {
  return scaled(q, inverse_length(dot(q, q)));
}

// All four components negated where the sign bit of `by` is set: the same rotation.
inline Quaternions flip(const Quaternions& q, f32x4 by) {
  return {flip(q.x, by), flip(q.y, by), flip(q.z, by), flip(q.w, by)};
}

// The rotation by |v| about v, for |v| ≤ 2π: unit within 1e-6; exactly the identity for 0.
inline Quaternions exp_rotation(const Vectors& v) {
  const f32x4 half = splat(0.5f);
  const Vectors h = {v.x * half, v.y * half, v.z * half};
  const f32x4 y = dot3(h.x, h.y, h.z, h.x, h.y, h.z);
  const f32x4 s = sinc_of_root(y);
  return {h.x * s, h.y * s, h.z * s, cos_of_root(y)};
}

// Axis times angle of unit quaternions with w > -½√2; the angle is in [0, 3π/2) and off by at most 1e-6 rad. Where w is
// less, the logarithm of -q, the wrong way round: callers choose the sign of q first.
inline Vectors log_rotation(const Quaternions& q) {
  const f32x4 zero = splat(0.0f), two = splat(2.0f), half_pi = splat(1.57079633f), half = splat(0.5f);
  const f32x4 sine_squared = dot3(q.x, q.y, q.z, q.x, q.y, q.z);
  const mask4 narrow = sine_squared < half;  // half the angle is within π/4 of 0; else it is near π/2
  const f32x4 part = asinc_of_root(select(narrow, sine_squared, q.w * q.w));
  const f32x4 wide = (half_pi - q.w * part) * inverse_length(select(narrow, zero, sine_squared));
  const f32x4 factor = two * select(narrow, part, wide);
  return {q.x * factor, q.y * factor, q.z * factor};
}

}  // namespace marrow
