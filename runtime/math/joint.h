// One joint of a pose.
#pragma once

#include "marrow/span.h"
#include "math/wide.h"

namespace marrow {

inline Rotation rotation_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&r)[4][4] = pose[joint / 4].rotation;
  const std::size_t lane = joint % 4;
  return {r[0][lane], r[1][lane], r[2][lane], r[3][lane]};
}
inline void set_rotation(Span<SoaTransform> pose, std::size_t joint, const Rotation& q) {
  float(&r)[4][4] = pose[joint / 4].rotation;
  const std::size_t lane = joint % 4;
  r[0][lane] = q.x;
  r[1][lane] = q.y;
  r[2][lane] = q.z;
  r[3][lane] = q.w;
}

inline WideRotation wide_rotation_of(Span<const SoaTransform> pose, std::size_t joint) {
  return {four_of_lane(&pose[joint / 4].rotation[0][joint % 4])};
}
inline void set_rotation(Span<SoaTransform> pose, std::size_t joint, WideRotation q) {
  set_four_of_lane(&pose[joint / 4].rotation[0][joint % 4], q.v);
}

inline f32x4 wide_translation_of(Span<const SoaTransform> pose, std::size_t joint) {
  return three_of_lane(&pose[joint / 4].translation[0][joint % 4]);
}
inline f32x4 wide_scale_of(Span<const SoaTransform> pose, std::size_t joint) {
  return three_of_lane(&pose[joint / 4].scale[0][joint % 4]);
}

inline Vector3 scale_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&s)[3][4] = pose[joint / 4].scale;
  const std::size_t lane = joint % 4;
  return {s[0][lane], s[1][lane], s[2][lane]};
}

}  // namespace marrow
