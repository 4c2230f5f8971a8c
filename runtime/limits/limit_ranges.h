// Angles as tangents of a quarter, and what is nearest in ranges, ellipses and boxes of them.
#pragma once

#include <cmath>

#include "marrow/limits.h"
#include "math/wide.h"

namespace marrow::ranges {

// A turn about some axis, as the sine and cosine of half its angle.
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

// 1 up to three quarters of the way from `edge` to `end`, and from there down to 0 at `end`.
inline float fade_out(float at, float edge, float end) {
  const float left = 4.0f * (end - at), room = end - edge;
  return left >= room ? 1.0f : left > 0 ? left / room : 0.0f;
}

// The nearest angle in the range; `share` of its way from the middle, unless the range is a whole turn.
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

// What may be beyond a limit, as a tangent of a quarter: what rounding leaves on it, and still within its tolerance.
inline constexpr float kSlack = 1e-6f;
// Whether an angle, as what is so many times longer than 1, is in the range.
inline bool contains(const AngleRange& range, const HalfAngle& angle, float length) {
  const HalfAngle d = angle + -half_angle(range.middle);
  return range.half_width >= 1.0f || absolute(d.sin) <= (range.half_width + kSlack) * (length + absolute(d.cos));
}

// A turn about one axis out of a rotation: the part v of its vector along that axis, and its w.
struct Twist {
  HalfAngle angle;
  float share;  // 1; where the rest turns by almost 180°, and the twist is about to be lost, down to 0
};
Twist twist_of(float v, float w);

// The point of the ellipse |(y / ry, z / rz)| = 1 that is nearest to (y, z), a point outside. Both radii are above 0.
struct Swing {
  float y, z;
};
Swing nearest_on_ellipse(const Swing& at, float ry, float rz);

}  // namespace marrow::ranges
