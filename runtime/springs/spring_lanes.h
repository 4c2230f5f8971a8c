// Four spring bones, a bone a lane, and taken apart one by one.
#pragma once

#include "math/joint.h"
#include "math/rotation.h"
#include "springs/spring_state.h"

namespace marrow {

inline constexpr int kLanes = 4;

// One vector in all lanes.
inline Vector<f32x4> in_all_lanes(f32x4 v) {
  return {splat_lane<0>(v), splat_lane<1>(v), splat_lane<2>(v)};
}
inline Vector<f32x4> join_vectors(const f32x4 (&v)[kLanes]) {
  f32x4 a = v[0], b = v[1], c = v[2], d = v[3];
  transpose(a, b, c, d);
  return {a, b, c};
}
inline Quaternion<f32x4> join_rotations(const f32x4 (&q)[kLanes]) {
  f32x4 a = q[0], b = q[1], c = q[2], d = q[3];
  transpose(a, b, c, d);
  return {a, b, c, d};
}
inline void split(const Vector<f32x4>& v, f32x4 (&out)[kLanes]) {
  out[0] = v.x, out[1] = v.y, out[2] = v.z, out[3] = splat(0.0f);
  transpose(out[0], out[1], out[2], out[3]);
}
inline void split(const Quaternion<f32x4>& q, f32x4 (&out)[kLanes]) {
  out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
  transpose(out[0], out[1], out[2], out[3]);
}

}  // namespace marrow
