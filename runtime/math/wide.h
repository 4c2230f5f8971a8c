// Vectors and rotations of one joint, each in a register: the bits of Vector3 and Rotation in fewer instructions. A
// vector is an f32x4 whose fourth lane is 0.
#pragma once

#include "math/quaternion.h"

namespace marrow {

using WideRotation = Quaternion<One>;

inline f32x4 operator*(f32x4 v, float s) {
  return v * splat(s);
}
inline f32x4 to_f32x4(const Vector3& v) {
  return lanes(v.x, v.y, v.z, 0.0f);
}
inline Vector3 narrow(f32x4 v) {
  float f[4];
  store(f, v);
  return {f[0], f[1], f[2]};
}
// Loads three numbers and clears lane w. It reads a fourth number, which must be readable.
inline f32x4 load_wide(const float* p) {
  return without_w(load(p));
}
// The same, but lane w is whatever follows in memory; ignore it. A denormal there may be slow.
inline f32x4 load_three(const float* p) {
  return load(p);
}
inline void store_wide(float* to, f32x4 v) {
  store(to, narrow(v));
}

// One joint's numbers out of arrays for four joints (SoA).
inline f32x4 three_of_lane(const float* p) {
  return lanes(p[0], p[4], p[8], 0.0f);
}
inline f32x4 four_of_lane(const float* p) {
  return lanes(p[0], p[4], p[8], p[12]);
}
inline void set_three_of_lane(float* to, f32x4 v) {
  float f[4];
  store(f, v);
  for (int i = 0; i < 3; ++i) to[4 * i] = f[i];
}
inline void set_four_of_lane(float* to, f32x4 v) {
  float f[4];
  store(f, v);
  for (int i = 0; i < 4; ++i) to[4 * i] = f[i];
}

// v.x, v.y, z, 0
inline f32x4 with_z(f32x4 v, float z) {
  float f[4];
  store(f, v);
  return lanes(f[0], f[1], z, 0.0f);
}

// The dot product of the first three lanes, summed from left to right.
inline float dot3(f32x4 a, f32x4 b) {
  const f32x4 p = a * b;
  return first_lane(p + splat_lane<1>(p) + splat_lane<2>(p));
}
inline float squared3(f32x4 v) {
  return dot3(v, v);
}
inline float length3(f32x4 v) {
  return sqrt(squared3(v));
}
inline f32x4 cross3(f32x4 a, f32x4 b) {
  return rotated_xyz(a * rotated_xyz(b) - rotated_xyz(a) * b);
}
// dot3() of three vectors, each with v.
inline f32x4 products(const f32x4 (&of)[3], f32x4 v) {
  return sums(of[0] * v, of[1] * v, of[2] * v);
}
// The part of v perpendicular to a unit vector.
inline f32x4 across3(f32x4 v, f32x4 unit) {
  return v - unit * dot3(v, unit);
}
// Of unit length; `otherwise` if it is too short to have a direction, or not finite.
inline f32x4 unit3_or(f32x4 v, f32x4 otherwise) {
  const float squared = squared3(v);
  return has_direction(squared) ? v * (1.0f / sqrt(squared)) : otherwise;
}
inline f32x4 any_across3(f32x4 v) {
  return any_across(Vector<One>{v}).v;
}

inline WideRotation no_turn() {
  return {lanes(0.0f, 0.0f, 0.0f, 1.0f)};
}
inline WideRotation quaternion(f32x4 axis, float w) {
  return {with_w(axis, splat(w))};
}
inline float w_lane(WideRotation q) {
  return first_lane(splat_lane<3>(q.v));
}
inline float dot4(f32x4 a, f32x4 b) {
  const f32x4 p = a * b;
  return first_lane(p + splat_lane<1>(p) + splat_lane<2>(p) + splat_lane<3>(p));
}
inline One dot(WideRotation a, WideRotation b) {
  return {splat(dot4(a.v, b.v))};
}
// Number by number: zeros of either sign are the same.
inline bool same(WideRotation a, WideRotation b) {
  return !any(a.v < b.v) && !any(b.v < a.v);
}
inline WideRotation conjugate(WideRotation q) {
  return {flip(q.v, lanes(-0.0f, -0.0f, -0.0f, 0.0f))};
}
// First b, then a.
inline WideRotation operator*(WideRotation a, WideRotation b) {
  const f32x4 minus_w = lanes(0.0f, 0.0f, 0.0f, -0.0f);
  const f32x4 first = splat_lane<3>(a.v) * b.v;
  const f32x4 second = flip(reordered<0, 1, 2, 0>(a.v) * reordered<3, 3, 3, 0>(b.v), minus_w);
  const f32x4 third = flip(reordered<1, 2, 0, 1>(a.v) * reordered<2, 0, 1, 1>(b.v), minus_w);
  const f32x4 fourth = reordered<2, 0, 1, 2>(a.v) * reordered<1, 2, 0, 2>(b.v);
  return {first + second + third - fourth};
}
// Of unit length; the identity if it is too short, or not finite.
inline WideRotation normalised(WideRotation q) {
  const float squared = dot4(q.v, q.v);
  return has_direction(squared) ? WideRotation{q.v * (1.0f / sqrt(squared))} : no_turn();
}
// v, turned.
inline f32x4 rotate(WideRotation q, f32x4 v) {
  const f32x4 half = cross3(q.v, v), t = half + half;
  return v + t * splat_lane<3>(q.v) + cross3(q.v, t);
}
// The shortest turn that takes the direction of `from` to that of `to`, of any lengths above 0; half a turn, about any
// axis across them, where they are opposite; the identity where either has no direction.
inline WideRotation shortest_arc(f32x4 from, f32x4 to) {
  const f32x4 a = unit3_or(from, splat(0.0f)), b = unit3_or(to, splat(0.0f)), sum = a + b;
  const float w = 0.5f * squared3(sum);  // 1 + cos, without cancellation
  if (w < 1e-8f) return !(squared3(a) > 0) ? no_turn() : WideRotation{any_across3(a)};
  return normalised(quaternion(cross3(a, b), w));
}

// See quaternion.h.
inline WideRotation share_of(WideRotation q, float share) {
  return share_of(q, all_lanes<One>(share));
}
inline WideRotation exp_rotation(f32x4 v) {
  return exp_rotation(Vector<One>{without_w(v)});
}

}  // namespace marrow
