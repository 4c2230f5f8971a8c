// Spheres and capsules that the ends of spring bones stay out of.
#pragma once

#include "math/vector.h"

namespace marrow {

struct PlacedCollider {
  Vector3 from, along;  // along: to the other end; 0 for a sphere
  float over_squared;   // 1 / |along|², or 0
  float radius;
};

inline Vector3 nearest_on(const PlacedCollider& c, const Vector3& point) {
  float t = dot(point - c.from, c.along) * c.over_squared;
  t = !(t > 0.0f) ? 0.0f : t < 1.0f ? t : 1.0f;
  return c.from + c.along * t;
}

// The direction of a bone whose end is too near to a point, `to_point` from the bone's joint: turned away to the edge
// of the cone of those that are less than `clear` away; straight away where all are.
inline Vector3 out_of_sphere(const Vector3& direction, float bone, const Vector3& to_point, float clear) {
  const float far = length(to_point);
  if (!(far * bone > 1e-12f)) return direction;
  const Vector3 m = to_point * (1.0f / far);
  float cosine = (bone * bone + far * far - clear * clear) / (2.0f * bone * far);
  cosine = cosine > -1.0f ? (cosine < 1.0f ? cosine : 1.0f) : -1.0f;
  const Vector3 side = normalised_or(across(direction, m), any_across(m));
  return normalised_or(m * cosine + side * sqrt(1.0f - cosine * cosine), direction);
}

// Both turned out of one collider; a velocity into it is lost. outwards: set where they touch.
inline void collide(const PlacedCollider& collider, const Vector3& joint, float bone, float radius, Vector3& direction,
                    Vector3& velocity, Vector3& outwards) {
  const float clear = collider.radius + radius;
  Vector3 to_point;
  bool touches = false;
  for (int i = 0; i < 3; ++i) {  // the nearest point of a capsule moves with the end
    const Vector3 end = joint + direction * bone, point = nearest_on(collider, end), out = end - point;
    if (!(dot(out, out) < clear * clear)) break;
    to_point = point - joint;
    direction = out_of_sphere(direction, bone, to_point, clear);
    touches = true;
    if (collider.over_squared == 0.0f) break;
  }
  if (!touches) return;
  outwards = normalised_or(direction * dot(to_point, direction) - to_point, {});
  velocity = across(velocity, direction);
  const float speed = dot(velocity, outwards);
  if (speed < 0.0f) velocity = velocity - outwards * speed;
}

}  // namespace marrow
