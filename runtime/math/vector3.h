// Three numbers, one joint or point at a time: where four at once do not fit the problem.
#pragma once

#include <cmath>

#include "math/finite.h"

namespace marrow {

struct Vector3 {
  float x = 0, y = 0, z = 0;
};

inline Vector3 vector3(const float* p) {
  return {p[0], p[1], p[2]};
}
inline void store(float* to, const Vector3& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator-(const Vector3& a) {
  return {-a.x, -a.y, -a.z};
}
inline Vector3 operator*(const Vector3& a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vector3 operator*(float s, const Vector3& a) {
  return a * s;
}

inline float dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

// Of unit length; `otherwise` if it is too short to have a direction, or not finite.
inline Vector3 normalised_or(const Vector3& a, const Vector3& otherwise) {
  const float squared = dot(a, a);
  if (!has_direction(squared)) return otherwise;
  return a * (1.0f / std::sqrt(squared));
}

// A unit vector across the unit vector v: of v and the axis that it is least along.
inline Vector3 any_across(const Vector3& v) {
  const float x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  const Vector3 axis = x <= y && x <= z ? Vector3{1, 0, 0} : y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
  return normalised_or(cross(v, axis), {1, 0, 0});
}

inline bool is_finite(const Vector3& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

}  // namespace marrow
