#include "limits/limit_ranges.h"

namespace marrow::ranges {

Twist twist_of(float v, float w) {
  const float n = sqrt(v * v + w * w);
  if (n < 1e-12f) return {{}, 0.0f};
  // The rest of the rotation turns by an angle with cos(angle / 2) = n.
  const float left = n < 1.0f ? sqrt((1.0f - n) / (1.0f + n)) : 0.0f;
  return {{v / n, w / n}, fade_out(left, 0.0f, 1.0f)};
}

// The point nearest to p has coordinates p_i e_i² / (e_i² + t), where e_i are the radii and t ≥ 0 puts it on the
// ellipse. On the ellipse the coordinates divided by e_i are a unit vector. The inverse of that vector's length is
// nearly linear in t, so Newton's method on it (Hebden 1973; Moré 1978, for trust regions) comes from below and never
// overshoots.
Swing nearest_on_ellipse(const Swing& at, float ry, float rz) {
  const float yy = ry * ry, zz = rz * rz, gy = ry * at.y, gz = rz * at.z;
  const float from_y = absolute(gy) - yy, from_z = absolute(gz) - zz;
  float t = from_y > from_z ? from_y : from_z;  // no component is above 1
  t = t > 0 ? t : 0.0f;
  float y = 0, z = 0, length = 1;
  for (int i = 0;; ++i) {
    const float ky = 1.0f / (yy + t), kz = 1.0f / (zz + t);
    y = gy * ky;
    z = gz * kz;
    const float squared = y * y + z * z;
    length = sqrt(squared);
    if (i == 5 || !(length > 1.0f)) break;
    t += squared / (y * y * ky + z * z * kz) * (length - 1.0f);
  }
  return {y / length * ry, z / length * rz};
}

}  // namespace marrow::ranges
