// One unit quaternion at a time; four at once are in quaternion.h.
#pragma once

#include <cstddef>

#include "marrow/pose.h"
#include "marrow/span.h"
#include "math/vector3.h"

namespace marrow {

struct Rotation {
  float x = 0, y = 0, z = 0, w = 1;
};

inline Rotation rotation(const float* p) {
  return {p[0], p[1], p[2], p[3]};
}
inline void store(float* to, const Rotation& q) {
  to[0] = q.x;
  to[1] = q.y;
  to[2] = q.z;
  to[3] = q.w;
}

// First b, then a.
inline Rotation operator*(const Rotation& a, const Rotation& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

inline Rotation conjugate(const Rotation& q) {
  return {-q.x, -q.y, -q.z, q.w};
}

inline float dot(const Rotation& a, const Rotation& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

inline Vector3 axis_part(const Rotation& q) {
  return {q.x, q.y, q.z};
}

// v, turned.
inline Vector3 rotate(const Rotation& q, const Vector3& v) {
  const Vector3 t = cross(axis_part(q), v) * 2.0f;
  return v + t * q.w + cross(axis_part(q), t);
}

// Of unit length; the identity if it is too short, or not finite.
inline Rotation normalised(const Rotation& q) {
  const float squared = dot(q, q);
  if (!has_direction(squared)) return {};
  const float s = 1.0f / std::sqrt(squared);
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}

// The shortest turn that takes the direction of `from` to that of `to`, of any lengths above 0; half a turn, about any
// axis across them, where they are opposite; the identity where either has no direction.
inline Rotation shortest_arc(const Vector3& from, const Vector3& to) {
  const Vector3 a = normalised_or(from, {}), b = normalised_or(to, {});
  const Vector3 sum = a + b;
  const float w = 0.5f * dot(sum, sum);  // 1 + cos, without cancellation
  if (w < 1e-8f) {
    if (dot(a, a) == 0) return {};
    const Vector3 across = any_across(a);
    return {across.x, across.y, across.z, 0.0f};
  }
  const Vector3 v = cross(a, b);
  return normalised(Rotation{v.x, v.y, v.z, w});
}

// The rotation in a map: its first axis keeps its direction, the second its side; scale, shear and mirroring are left
// out. Axes without a direction are made up.
inline Rotation rotation_of(const Affine& a) {
  const Vector3 x = normalised_or({a.rows[0][0], a.rows[1][0], a.rows[2][0]}, {1, 0, 0});
  const Vector3 second = {a.rows[0][1], a.rows[1][1], a.rows[2][1]};
  const Rotation first = shortest_arc({1, 0, 0}, x);
  // Then about x, to the side of the second axis.
  const Vector3 from = rotate(first, {0, 1, 0}), to = normalised_or(second - x * dot(x, second), from);
  const float cosine = dot(from, to), sine = dot(x, cross(from, to));
  const Vector3 v = x * (cosine > -0.9999999f ? sine : 1.0f);
  return normalised(Rotation{v.x, v.y, v.z, cosine > -0.9999999f ? 1 + cosine : 0.0f}) * first;
}

inline Rotation rotation_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&r)[4][4] = pose[joint / 4].rotation;
  const std::size_t lane = joint % 4;
  return {r[0][lane], r[1][lane], r[2][lane], r[3][lane]};
}
inline void set_rotation(Span<SoaTransform> pose, std::size_t joint, const Rotation& q) {
  float(&r)[4][4] = pose[joint / 4].rotation;
  const std::size_t lane = joint % 4;
  r[0][lane] = q.x;
  r[1][lane] = q.y;
  r[2][lane] = q.z;
  r[3][lane] = q.w;
}

inline Vector3 translation_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&t)[3][4] = pose[joint / 4].translation;
  const std::size_t lane = joint % 4;
  return {t[0][lane], t[1][lane], t[2][lane]};
}
inline Vector3 scale_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&s)[3][4] = pose[joint / 4].scale;
  const std::size_t lane = joint % 4;
  return {s[0][lane], s[1][lane], s[2][lane]};
}

inline Vector3 origin(const Affine& a) {
  return {a.rows[0][3], a.rows[1][3], a.rows[2][3]};
}
// A direction through the linear part.
inline Vector3 turn(const Affine& a, const Vector3& v) {
  return {a.rows[0][0] * v.x + a.rows[0][1] * v.y + a.rows[0][2] * v.z,
          a.rows[1][0] * v.x + a.rows[1][1] * v.y + a.rows[1][2] * v.z,
          a.rows[2][0] * v.x + a.rows[2][1] * v.y + a.rows[2][2] * v.z};
}
inline Vector3 transform(const Affine& a, const Vector3& point) {
  return turn(a, point) + origin(a);
}

}  // namespace marrow
