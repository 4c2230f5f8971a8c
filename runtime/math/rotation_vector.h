// One rotation at a time to its rotation vector, axis times angle, and back; four at once are in quaternion.h.
#pragma once

#include "math/quaternion.h"
#include "math/rotation.h"

namespace marrow {

// By |v| about v, |v| ≤ 2π; v: x, y, z.
inline Rotation exp_rotation(f32x4 v) {
  Quaternions q = exp_rotation({splat_lane<0>(v), splat_lane<1>(v), splat_lane<2>(v)});
  transpose(q.x, q.y, q.z, q.w);
  Rotation out;
  store(&out.x, q.x);
  return out;
}

// Of a unit quaternion, the shorter way: x, y, z, 0; at most π long.
inline f32x4 log_rotation(const Rotation& unit) {
  f32x4 q = load(&unit.x);
  q = flip(q, splat_lane<3>(q));
  Vectors v = log_rotation({splat_lane<0>(q), splat_lane<1>(q), splat_lane<2>(q), splat_lane<3>(q)});
  f32x4 none = splat(0.0f);
  transpose(v.x, v.y, v.z, none);
  return v.x;
}

}  // namespace marrow
