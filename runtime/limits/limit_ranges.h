// Angles as tangents of their quarters, and the nearest ones in ranges and ellipses.
#pragma once

#include <cmath>

#include "marrow/limits.h"
#include "math/wide.h"

namespace marrow::ranges {

// An angle, as the sine and cosine of its half.
struct HalfAngle {
  float sin = 0, cos = 1;
};

inline HalfAngle half_angle(float quarter_tangent) {
  const float squared = quarter_tangent * quarter_tangent, k = 1.0f / (1.0f + squared);
  return {2.0f * quarter_tangent * k, (1.0f - squared) * k};
}
inline HalfAngle operator+(const HalfAngle& a, const HalfAngle& b) {
  return {a.sin * b.cos + a.cos * b.sin, a.cos * b.cos - a.sin * b.sin};
}
inline HalfAngle operator-(const HalfAngle& a) {
  return {-a.sin, a.cos};
}

// 1 up to three quarters of the way from `edge` to `end`; from there it falls to 0 at `end`.
inline float fade_out(float at, float edge, float end) {
  const float left = 4.0f * (end - at), room = end - edge;
  return left >= room ? 1.0f : left > 0 ? left / room : 0.0f;
}

// The angle in the range that is nearest, moved to `share` of its way from the middle unless the range is a whole turn.
inline HalfAngle nearest_in(const AngleRange& range, const HalfAngle& angle, float share) {
  if (range.half_width >= 1.0f) return angle;
  const HalfAngle middle = half_angle(range.middle);
  HalfAngle d = angle + -middle;
  if (d.cos < 0) d = {-d.sin, -d.cos};
  float t = d.sin / (1.0f + d.cos);
  const float size = absolute(t);
  if (size > range.half_width) t = std::copysign(range.half_width * fade_out(size, range.half_width, 1.0f), t);
  return half_angle(t * share) + middle;
}

// How far beyond a limit an angle counts as inside, as a tangent of a quarter: more than rounding, less than the
// limits' tolerance.
inline constexpr float kSlack = 1e-6f;
// Whether an angle is in the range. length: of its sine and cosine, which need not be 1.
inline bool contains(const AngleRange& range, const HalfAngle& angle, float length) {
  const HalfAngle d = angle + -half_angle(range.middle);
  return range.half_width >= 1.0f || absolute(d.sin) <= (range.half_width + kSlack) * (length + absolute(d.cos));
}

// The twist of a rotation about an axis. v: the part of its vector along that axis.
struct Twist {
  HalfAngle angle;
  float share;  // 1; falls to 0 where the rest turns by almost 180° and the twist is lost
};
Twist twist_of(float v, float w);

// A swing about y and z, as tangents of a quarter.
struct Swing {
  float y, z;
};
// The point of the ellipse |(y / ry, z / rz)| = 1 nearest to `at`, which is outside. Both radii are above 0.
Swing nearest_on_ellipse(const Swing& at, float ry, float rz);

}  // namespace marrow::ranges
