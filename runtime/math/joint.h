// One joint of a pose.
#pragma once

#include "core/fixed.h"
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
  const float* const r = &pose[joint / 4].rotation[0][joint % 4];
  return {lanes(r[0], r[4], r[8], r[12])};
}
inline void set_rotation(Span<SoaTransform> pose, std::size_t joint, WideRotation q) {
  float* const r = &pose[joint / 4].rotation[0][joint % 4];
  float f[4];
  store(f, q.v);
  for (int i = 0; i < 4; ++i) r[4 * i] = f[i];
}

MARROW_CALLED_WHERE_SMALL inline f32x4 wide_translation_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float* const t = &pose[joint / 4].translation[0][joint % 4];
  return lanes(t[0], t[4], t[8], 0.0f);
}
MARROW_CALLED_WHERE_SMALL inline f32x4 wide_scale_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float* const s = &pose[joint / 4].scale[0][joint % 4];
  return lanes(s[0], s[4], s[8], 0.0f);
}

inline Vector3 scale_of(Span<const SoaTransform> pose, std::size_t joint) {
  const float(&s)[3][4] = pose[joint / 4].scale;
  const std::size_t lane = joint % 4;
  return {s[0][lane], s[1][lane], s[2][lane]};
}

}  // namespace marrow
