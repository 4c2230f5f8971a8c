// Spheres and capsules, out of which the ends of spring bones stay.
#pragma once

#include "math/wide.h"

namespace marrow {

struct PlacedCollider {
  f32x4 from, along;   // one end, and the way to the other; 0 for a sphere
  float over_squared;  // 1 / |along|², or 0
  float radius;
};

inline f32x4 nearest_on(const PlacedCollider& c, f32x4 point) {
  float t = dot3(point - c.from, c.along) * c.over_squared;
  t = !(t > 0.0f) ? 0.0f : t < 1.0f ? t : 1.0f;
  return c.from + c.along * t;
}

// The direction of a bone, turned away from a point until the bone's end is `clear` from it; straight away from the
// point if that is not enough. to_point: from the bone's joint.
inline f32x4 out_of_sphere(f32x4 direction, float bone, f32x4 to_point, float clear) {
  const float far = length3(to_point);
  if (!(far * bone > 1e-12f)) return direction;
  const f32x4 m = to_point * (1.0f / far);
  float cosine = (bone * bone + far * far - clear * clear) / (2.0f * bone * far);
  cosine = cosine > -1.0f ? (cosine < 1.0f ? cosine : 1.0f) : -1.0f;
  const f32x4 side = unit3_or(across3(direction, m), any_across3(m));
  return unit3_or(m * cosine + side * sqrt(1.0f - cosine * cosine), direction);
}

// Turns a bone's direction and velocity out of a collider, and takes off velocity into it. outwards: set if they touch.
inline void collide(const PlacedCollider& collider, f32x4 joint, float bone, float radius, f32x4& direction,
                    f32x4& velocity, f32x4& outwards) {
  const float clear = collider.radius + radius;
  f32x4 to_point = splat(0.0f);
  bool touches = false;
  for (int i = 0; i < 3; ++i) {  // of a capsule the nearest point moves along with the end
    const f32x4 end = joint + direction * bone, point = nearest_on(collider, end), out = end - point;
    if (!(squared3(out) < clear * clear)) break;
    to_point = point - joint;
    direction = out_of_sphere(direction, bone, to_point, clear);
    touches = true;
    if (collider.over_squared == 0.0f) break;
  }
  if (!touches) return;
  outwards = unit3_or(direction * dot3(to_point, direction) - to_point, splat(0.0f));
  velocity = across3(velocity, direction);
  const float speed = dot3(velocity, outwards);
  if (speed < 0.0f) velocity = velocity - outwards * speed;
}

}  // namespace marrow
