// Joint limits in double precision, from their descriptions, by matrices and a library's trigonometry.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "marrow/limits.h"
#include "support/double_math.h"

namespace marrow::test {

constexpr double kPi = 3.14159265358979323846;

using Mat3 = std::array<std::array<double, 3>, 3>;

inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 m{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) m[r][c] += a[r][k] * b[k][c];
  return m;
}
inline Mat3 transposed(const Mat3& a) {
  Mat3 m{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] = a[c][r];
  return m;
}
inline Mat3 matrix(const Quat& unit) {
  const Map map = from_trs({0, 0, 0}, unit, {1, 1, 1});
  Mat3 m{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] = map.rows[r][c];
  return m;
}
inline Mat3 about(std::size_t axis, double angle_rad) {
  Vec3 v = {0, 0, 0};
  v[axis] = 1;
  return matrix(axis_angle(v, angle_rad));
}
inline Quat quat(const float (&q)[4]) {
  return normalised(Quat{q[0], q[1], q[2], q[3]});
}

// By the largest of its components (Shepperd 1978).
inline Quat quat(const Mat3& m) {
  const Quat squares = {1 + m[0][0] - m[1][1] - m[2][2], 1 - m[0][0] + m[1][1] - m[2][2],
                        1 - m[0][0] - m[1][1] + m[2][2], 1 + m[0][0] + m[1][1] + m[2][2]};
  const double xy = m[1][0] + m[0][1], xz = m[0][2] + m[2][0], yz = m[2][1] + m[1][2];
  const double xw = m[2][1] - m[1][2], yw = m[0][2] - m[2][0], zw = m[1][0] - m[0][1];
  const Quat rows[4] = {
      {squares[0], xy, xz, xw}, {xy, squares[1], yz, yw}, {xz, yz, squares[2], zw}, {xw, yw, zw, squares[3]}};
  return normalised(rows[std::max_element(squares.begin(), squares.end()) - squares.begin()]);
}

// The angle of the turn from one rotation to the other.
inline double angle_between(const Mat3& a, const Mat3& b) {
  const Mat3 d = transposed(a) * b;
  const Vec3 v = {d[2][1] - d[1][2], d[0][2] - d[2][0], d[1][0] - d[0][1]};
  return std::atan2(length(v), d[0][0] + d[1][1] + d[2][2] - 1);
}

// The columns are the limit's axes in the joint's.
inline Mat3 limit_axes(const LimitDescription& d) {
  const Vec3 x = normalised(Vec3{d.axis[0], d.axis[1], d.axis[2]});
  const Vec3 z = normalised(cross(x, Vec3{d.across[0], d.across[1], d.across[2]})), y = cross(z, x);
  Mat3 m{};
  for (std::size_t r = 0; r < 3; ++r) m[r] = {x[r], y[r], z[r]};
  return m;
}
inline Mat3 in_limit_axes(const LimitDescription& d, const Mat3& local) {
  const Mat3 axes = limit_axes(d);
  return transposed(matrix(quat(d.zero)) * axes) * local * axes;
}
inline Mat3 from_limit_axes(const LimitDescription& d, const Mat3& t) {
  const Mat3 axes = limit_axes(d);
  return matrix(quat(d.zero)) * axes * t * transposed(axes);
}

// How far an angle is from the nearer end of a range, whole turns aside; 0 inside.
inline double outside(double angle, double least, double most) {
  const double middle = (least + most) / 2;
  return std::max(0.0, std::fabs(std::remainder(angle - middle, 2 * kPi)) - (most - least) / 2);
}

struct SwingTwist {
  double y, z;  // tan of a quarter of the swing, times its axis
  double twist;
};
inline SwingTwist swing_twist(const Mat3& t) {
  const Vec3 x = {t[0][0], t[1][0], t[2][0]};  // where x points
  const double sine = std::hypot(x[1], x[2]), swing = std::atan2(sine, x[0]);
  const Vec3 axis = sine > 0 ? Vec3{0, -x[2] / sine, x[1] / sine} : Vec3{0, 1, 0};  // e_x × x
  const Mat3 twist = transposed(matrix(axis_angle(axis, swing))) * t;
  const double size = std::tan(swing / 4);
  return {axis[1] * size, axis[2] * size, std::atan2(twist[2][1], twist[1][1])};
}

struct Axes {
  std::size_t i, j, k;
  double sign;
};
inline Axes axes_of(AxisOrder order) {
  constexpr Axes kAll[] = {{0, 1, 2, 1}, {0, 2, 1, -1}, {1, 0, 2, -1}, {1, 2, 0, 1}, {2, 0, 1, 1}, {2, 1, 0, -1}};
  return kAll[static_cast<std::size_t>(order)];
}
inline Mat3 euler(AxisOrder order, double a, double b, double c) {
  const Axes o = axes_of(order);
  return about(o.i, a) * about(o.j, b) * about(o.k, c);
}

// By how many radians a rotation is outside, the largest of its components.
inline double reference_excess(const LimitDescription& d, const Mat3& local) {
  const Mat3 t = in_limit_axes(d, local);
  if (d.kind == LimitKind::euler) {
    const Axes o = axes_of(d.order);
    const double a = std::atan2(-o.sign * t[o.j][o.k], t[o.k][o.k]), c = std::atan2(-o.sign * t[o.i][o.j], t[o.i][o.i]);
    const double b = std::atan2(o.sign * t[o.i][o.k], std::hypot(t[o.i][o.i], t[o.i][o.j]));
    return std::max({outside(a, d.least_rad[0], d.most_rad[0]), outside(b, d.least_rad[1], d.most_rad[1]),
                     outside(c, d.least_rad[2], d.most_rad[2])});
  }
  const SwingTwist s = swing_twist(t);
  const double twist = outside(s.twist, d.least_rad[0], d.most_rad[0]), size = std::hypot(s.y, s.z);
  double swing = 4 * std::atan(size);
  if (d.kind == LimitKind::cone) {
    const double ry = std::tan(std::max<double>(d.most_rad[1], 1e-9) / 4);
    const double rz = std::tan(std::max<double>(d.most_rad[2], 1e-9) / 4);
    // The distance from the ellipse to first order, level over slope; and what a step there is in radians.
    const double level = std::hypot(s.y / ry, s.z / rz);
    const double slope = std::hypot(s.y / (ry * ry), s.z / (rz * rz)) / std::max(level, 1e-9);
    swing = level > 1 ? (level - 1) / slope * 4 / (1 + size * size) : 0;
  }
  return std::max(swing, twist);
}

// A rotation of the limit from three numbers 0 … 1; all of them are reached.
inline Mat3 rotation_inside(const LimitDescription& d, double u, double v, double w) {
  const auto at = [&](int i, double share) {
    const double least = d.least_rad[i], most = d.most_rad[i];
    return least + share * (most - least);
  };
  if (d.kind == LimitKind::euler) return from_limit_axes(d, euler(d.order, at(0, u), at(1, v), at(2, w)));
  Mat3 swing = about(0, 0);
  if (d.kind == LimitKind::cone) {
    const double y = std::tan(static_cast<double>(d.most_rad[1]) / 4) * v * std::cos(2 * kPi * w);
    const double z = std::tan(static_cast<double>(d.most_rad[2]) / 4) * v * std::sin(2 * kPi * w);
    if (std::hypot(y, z) > 0) swing = matrix(axis_angle({0, y, z}, 4 * std::atan(std::hypot(y, z))));
  }
  return from_limit_axes(d, swing * about(0, at(0, u)));
}

using LimitRandom = std::mt19937;
inline double uniform(LimitRandom& random, double least, double most) {
  return least + (most - least) * (static_cast<double>(random()) / 4294967296.0);
}
// Evenly over all rotations (Shoemake 1992).
inline Quat any_rotation(LimitRandom& random) {
  const double u = uniform(random, 0, 1), a = uniform(random, 0, 2 * kPi), b = uniform(random, 0, 2 * kPi);
  const double s = std::sqrt(1 - u), t = std::sqrt(u);
  return {s * std::sin(a), s * std::cos(a), t * std::sin(b), t * std::cos(b)};
}
inline void set(float (&to)[4], const Quat& q) {
  for (std::size_t i = 0; i < 4; ++i) to[i] = static_cast<float>(q[i]);
}

// A limit of some kind, anywhere; half of the ranges up to `widest` radians to each side of the middle.
inline LimitDescription any_limit(LimitRandom& random, LimitKind kind, double widest = 2.5) {
  LimitDescription d;
  d.kind = kind;
  set(d.zero, any_rotation(random));
  for (float& a : d.axis) a = static_cast<float>(uniform(random, -1, 1));
  for (float& a : d.across) a = static_cast<float>(uniform(random, -1, 1));
  const auto range = [&](int i, double half, double reach) {
    half = uniform(random, 0, half);
    const double middle = uniform(random, -(reach - half), reach - half);
    d.least_rad[i] = static_cast<float>(middle - half);
    d.most_rad[i] = static_cast<float>(middle + half);
  };
  range(0, widest, kPi);
  if (kind == LimitKind::cone) {
    for (int i = 1; i < 3; ++i) {
      d.most_rad[i] = static_cast<float>(uniform(random, 0, std::min(widest, 2.9)));
      d.least_rad[i] = -d.most_rad[i];
    }
  }
  if (kind == LimitKind::euler) {
    d.order = static_cast<AxisOrder>(random() % 6);
    range(1, std::min(widest, 1.48), 1.48);
    range(2, widest, kPi);
  }
  return d;
}
constexpr LimitKind kAllKinds[] = {LimitKind::hinge, LimitKind::cone, LimitKind::euler};

}  // namespace marrow::test
