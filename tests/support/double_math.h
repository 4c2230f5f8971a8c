// Vectors, quaternions and affine maps in double precision, for expected values that owe nothing to the runtime's own
// arithmetic.
#pragma once

#include <array>
#include <cmath>

namespace marrow::test {

using Vec3 = std::array<double, 3>;
using Quat = std::array<double, 4>;  // x, y, z, w

// Three rows of four, as marrow::Affine; double.
struct Map {
  double rows[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
};

inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}
inline Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// The zero vector stays zero.
inline Vec3 normalised(const Vec3& a) {
  const double l = length(a);
  return l > 0 ? Vec3{a[0] / l, a[1] / l, a[2] / l} : Vec3{0, 0, 0};
}
// Angle between two directions of any length; atan2 keeps small angles exact where acos would not.
inline double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 57.29577951308232;
}

inline Quat normalised(const Quat& q) {
  const double l = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / l, q[1] / l, q[2] / l, q[3] / l};
}

inline Quat axis_angle(const Vec3& axis, double angle_rad) {
  const Vec3 n = normalised(axis);
  const double s = std::sin(angle_rad / 2);
  return {n[0] * s, n[1] * s, n[2] * s, std::cos(angle_rad / 2)};
}

// Spherical interpolation along the shorter arc: glTF 2.0, appendix C.4.
inline Quat slerp(const Quat& a, const Quat& b, double t) {
  const double d = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double angle = std::acos(std::fmin(std::fabs(d), 1.0));
  const double sign = d < 0 ? -1.0 : 1.0;
  double u = 1 - t, v = t;
  if (angle > 1e-9) {
    u = std::sin(angle * (1 - t)) / std::sin(angle);
    v = std::sin(angle * t) / std::sin(angle);
  }
  Quat r{};
  for (std::size_t i = 0; i < 4; ++i) r[i] = u * a[i] + sign * v * b[i];
  return normalised(r);
}

// translate · rotate · scale.
inline Map from_trs(const Vec3& t, const Quat& unit, const Vec3& s) {
  const double x = unit[0], y = unit[1], z = unit[2], w = unit[3];
  return Map{{{(1 - 2 * (y * y + z * z)) * s[0], 2 * (x * y - z * w) * s[1], 2 * (x * z + y * w) * s[2], t[0]},
              {2 * (x * y + z * w) * s[0], (1 - 2 * (x * x + z * z)) * s[1], 2 * (y * z - x * w) * s[2], t[1]},
              {2 * (x * z - y * w) * s[0], 2 * (y * z + x * w) * s[1], (1 - 2 * (x * x + y * y)) * s[2], t[2]}}};
}

inline Map operator*(const Map& a, const Map& b) {
  Map m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) {
      m.rows[r][c] = a.rows[r][0] * b.rows[0][c] + a.rows[r][1] * b.rows[1][c] + a.rows[r][2] * b.rows[2][c];
    }
    m.rows[r][3] += a.rows[r][3];
  }
  return m;
}

inline Vec3 point(const Map& m, const Vec3& p) {
  Vec3 out{};
  for (std::size_t r = 0; r < 3; ++r) {
    out[r] = m.rows[r][0] * p[0] + m.rows[r][1] * p[1] + m.rows[r][2] * p[2] + m.rows[r][3];
  }
  return out;
}

inline Vec3 direction(const Map& m, const Vec3& d) {
  Vec3 out{};
  for (std::size_t r = 0; r < 3; ++r) out[r] = m.rows[r][0] * d[0] + m.rows[r][1] * d[1] + m.rows[r][2] * d[2];
  return out;
}

inline Vec3 row(const Map& m, int r) {
  return {m.rows[r][0], m.rows[r][1], m.rows[r][2]};
}

inline double determinant(const Map& m) {
  return dot(row(m, 0), cross(row(m, 1), row(m, 2)));
}

// How far the 3×3 part is from singular, whatever its scale: 1 for a similarity, 0 for a projection.
inline double invertibility(const Map& m) {
  const double square = (dot(row(m, 0), row(m, 0)) + dot(row(m, 1), row(m, 1)) + dot(row(m, 2), row(m, 2))) / 3;
  return square > 0 ? std::fabs(determinant(m)) / (square * std::sqrt(square)) : 0;
}

// A normal through the inverse transpose of the 3×3 part: its cofactors divided by the determinant, whose sign matters.
inline Vec3 normal(const Map& m, const Vec3& n) {
  const Vec3 a = cross(row(m, 1), row(m, 2)), b = cross(row(m, 2), row(m, 0)), c = cross(row(m, 0), row(m, 1));
  const double sign = determinant(m) < 0 ? -1 : 1;
  return normalised(Vec3{sign * dot(a, n), sign * dot(b, n), sign * dot(c, n)});
}

}  // namespace marrow::test
