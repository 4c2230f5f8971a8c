// Rigid motions in double precision: products, powers, and the screws that are their logarithms. For what adds up
// over many steps.
#pragma once

#include "math/quaternion.h"

namespace marrow {

// Turns, then moves.
struct RigidMotion {
  Quaternion<double> rotation;  // of unit length
  Vector<double> translation;
};

// Little code is wanted here rather than speed, so what is used twice is a function of its own.

[[gnu::noinline]] inline Vector<double> vector_of_doubles(const float* p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}
// Of unit length; the identity if it has no direction.
[[gnu::noinline]] inline Quaternion<double> unit_rotation(const Quaternion<double>& q) {
  const double squared = dot(q, q);
  return squared > 1e-60 ? q * (1.0 / square_root(squared)) : Quaternion<double>{};
}
// As they are stored: the rotation is not normalised.
[[gnu::noinline]] inline RigidMotion stored_rigid(const float* rotation, const float* translation) {
  return {quaternion(vector_of_doubles(rotation), static_cast<double>(rotation[3])), vector_of_doubles(translation)};
}
// v + a (axis × v) + b (axis × (axis × v)): every turn and every screw is such a sum.
[[gnu::noinline]] inline Vector<double> helix(const Vector<double>& axis, const Vector<double>& v, double a, double b) {
  const Vector<double> across = cross(axis, v);
  return v + across * a + cross(axis, across) * b;
}
inline Vector<double> turned(const Quaternion<double>& q, const Vector<double>& v) {
  return helix(axis_part(q), v, 2.0 * q.w, 2.0);
}

// First b, then a.
[[gnu::noinline]] inline RigidMotion operator*(const RigidMotion& a, const RigidMotion& b) {
  return {unit_rotation(a.rotation * b.rotation), a.translation + turned(a.rotation, b.translation)};
}
[[gnu::noinline]] inline RigidMotion inverse(const RigidMotion& a) {
  const Quaternion<double> back = conjugate(a.rotation);
  return {back, -turned(back, a.translation)};
}
// aⁿ, by squaring: at most 126 products. n is above -2⁶³.
[[gnu::noinline]] inline RigidMotion power(const RigidMotion& a, std::int64_t n) {
  RigidMotion out, square = n < 0 ? inverse(a) : a;
  for (std::int64_t left = n < 0 ? -n : n; left > 0; left >>= 1) {
    if ((left & 1) != 0) out = out * square;
    square = square * square;
  }
  return out;
}

// Sine over angle, and cosine, of √y for y in [0, 2.5]: a little more than a quarter turn. Taylor's series.
struct SincCos {
  double sinc, cos;
};
[[gnu::noinline]] inline SincCos sinc_cos_of_root(double y) {
  SincCos out{1, 1};
  for (int k = 24; k > 0; k -= 2) {
    out.sinc = 1.0 - y * out.sinc / static_cast<double>(k * (k + 1));
    out.cos = 1.0 - y * out.cos / static_cast<double>(k * (k - 1));
  }
  return out;
}

// A turn about an axis and a way along and across it, both evenly. (R. Murray, Z. Li, S. Sastry, A Mathematical
// Introduction to Robotic Manipulation, 1994, section 2.3.)
struct Screw {
  Vector<double> turn;  // axis times angle
  Vector<double> way;
};

// Below this square of half the angle what divides by it takes its limit, which is then nearer than rounding.
inline constexpr double kNoTurn = 1e-8;

// Half an angle over its sine, for that and a cosine ≥ 0; within 2e-7 of itself.
inline double half_angle_over_sine(double sine, double cosine) {
  const auto s = static_cast<float>(sine), c = static_cast<float>(cosine);
  return static_cast<double>(s < c ? asinc_of_root(s * s) : (1.57079633f - asinc_of_root(c * c) * c) / s);
}

// The shorter way round.
[[gnu::noinline]] inline Screw screw_of(const RigidMotion& m) {
  const Quaternion<double> q = m.rotation.w < 0 ? m.rotation * -1.0 : m.rotation;
  const double sine = square_root(dot(axis_part(q), axis_part(q))), over = half_angle_over_sine(sine, q.w);
  const double square = over * sine * over * sine;
  const Vector<double> turn = axis_part(q) * (2.0 * over);
  const double k = square < kNoTurn ? 1.0 / 12 : (1.0 - over * q.w) / (4.0 * square);
  return {turn, helix(turn, m.translation, -0.5, k)};
}

// The motion of a screw of at most half a turn.
[[gnu::noinline]] inline RigidMotion motion_of(const Screw& s) {
  const double square = dot(s.turn, s.turn) * 0.25;
  if (square == 0) return {{}, s.way};
  const SincCos half = sinc_cos_of_root(square);
  const double k = square < kNoTurn ? 1.0 / 6 : (1.0 - half.sinc * half.cos) / (4.0 * square);
  return {quaternion(s.turn * (0.5 * half.sinc), half.cos), helix(s.turn, s.way, 0.5 * half.sinc * half.sinc, k)};
}

}  // namespace marrow
