#include "marrow/limits.h"

#include "core/check.h"
#include "core/zone.h"
#include "limits/joint_limit.h"
#include "limits/limit_ranges.h"
#include "math/joint.h"

namespace marrow::ranges {
namespace {

enum Axis : std::uint8_t { kX, kY, kZ };

WideRotation about(Axis axis, const HalfAngle& a) {
  return {lanes(axis == kX ? a.sin : 0, axis == kY ? a.sin : 0, axis == kZ ? a.sin : 0, a.cos)};
}

// The turn about an axis, within the range, that is nearest to the rotation's own twist.
WideRotation nearest_about(Axis axis, const AngleRange& range, WideRotation t) {
  float q[4];
  store(q, t.v);
  const Twist twist = twist_of(q[axis], q[3]);
  return about(axis, nearest_in(range, twist.angle, twist.share));
}

// A cheap test for rotations inside: true is certain, false is not.
bool is_in_cone(float ry, float rz, const AngleRange& twist, WideRotation t) {
  float q[4];
  store(q, t.v);
  const float n = sqrt(q[0] * q[0] + q[3] * q[3]), border = n * (1.0f + n) * (ry * rz + kSlack * lesser(ry, rz));
  const float y = (q[1] * q[3] - q[2] * q[0]) * rz, z = (q[2] * q[3] + q[1] * q[0]) * ry;
  return n > 1e-3f && y * y + z * z <= border * border && contains(twist, {q[0], q[3]}, n);
}

WideRotation nearest_in_cone(const JointLimit& limit, WideRotation t) {
  constexpr float kLeast = 1e-6f;  // a cone may be flat
  const float ry = greater(limit.angles[1].half_width, kLeast), rz = greater(limit.angles[2].half_width, kLeast);
  if (is_in_cone(ry, rz, limit.angles[0], t)) return t;
  float swing[4];
  store(swing, (t * conjugate(about(kX, twist_of(first_lane(t.v), w_lane(t)).angle))).v);
  const float k = 1.0f / (1.0f + (swing[3] > 0 ? swing[3] : 0.0f));
  Swing s = {swing[1] * k, swing[2] * k};
  const float squared = s.y * s.y + s.z * s.z, widest = ry > rz ? ry : rz;
  float share = 1;
  const float y = s.y * rz, z = s.z * ry, border = ry * rz;
  if (y * y + z * z > border * border) {
    s = nearest_on_ellipse(s, ry, rz);
    share = fade_out(sqrt(squared), widest, 1.0f);
  }
  s = {s.y * share, s.z * share};
  const float size = s.y * s.y + s.z * s.z, scale = 1.0f / (1.0f + size);
  const WideRotation in = {lanes(0, 2.0f * s.y * scale, 2.0f * s.z * scale, (1.0f - size) * scale)};
  // The nearest twist for this swing.
  return in * nearest_about(kX, limit.angles[0], conjugate(in) * t);
}

// An angle from its sine and cosine, both times any length.
HalfAngle half_of(float sin, float cos) {
  const float size = sqrt(sin * sin + cos * cos);
  if (size < 1e-12f) return {};
  const HalfAngle half =
      cos > 0 ? HalfAngle{sin, size + cos} : HalfAngle{std::copysign(size - cos, sin), absolute(sin)};
  const float k = 1.0f / sqrt(half.sin * half.sin + half.cos * half.cos);
  return {half.sin * k, half.cos * k};
}

// Reads the second and third angle off t = Rx Ry Rz. Where the second is near 90° (gimbal lock) the third is lost and
// moves to the middle of its range. Then each angle in turn becomes the nearest one for the other two.
WideRotation nearest_in_xyz(const AngleRange (&angles)[3], WideRotation t) {
  float q[4];
  store(q, t.v);
  const float x = q[0], y = q[1], z = q[2], w = q[3];
  const float sin_z = 2.0f * (w * z - x * y), cos_z = w * w + x * x - y * y - z * z;
  const float cos_y = sqrt(sin_z * sin_z + cos_z * cos_z);
  const HalfAngle second = half_of(2.0f * (w * y + x * z), cos_y), third = half_of(sin_z, cos_z);
  // Away from 90° the first angle is read off too; a rotation that is inside stays as it is.
  if (cos_y > 0.1f && contains(angles[1], second, 1.0f) && contains(angles[2], third, 1.0f) &&
      contains(angles[0], half_of(2.0f * (w * x - y * z), w * w - x * x - y * y + z * z), 1.0f))
    return t;
  constexpr float kQuarterTurn = 0.41421356f;  // 90°, as the tangent of a quarter
  const float most = absolute(angles[1].middle), half = angles[1].half_width;
  const float widest = (most + half) / (1.0f - most * half);
  const float share =
      widest < kQuarterTurn - 1e-5f ? fade_out(absolute(second.sin) / (1.0f + second.cos), widest, kQuarterTurn) : 1.0f;
  const WideRotation y0 = about(kY, nearest_in(angles[1], second, 1.0f));
  const WideRotation z0 = about(kZ, nearest_in(angles[2], third, share));
  const WideRotation x1 = nearest_about(kX, angles[0], t * conjugate(y0 * z0));
  const WideRotation z1 = nearest_about(kZ, angles[2], conjugate(x1 * y0) * t);
  return x1 * nearest_about(kY, angles[1], conjugate(x1) * t * conjugate(z1)) * z1;
}

// Renames axes so that the order is xyz. Where that mirrors them, rotations and ranges turn the other way.
WideRotation nearest_in_box(const JointLimit& limit, WideRotation t) {
  static constexpr std::uint8_t kAxes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  static constexpr float kSigns[6] = {1, -1, -1, 1, 1, -1};
  const auto order = static_cast<std::size_t>(limit.order);
  const std::uint8_t(&axes)[3] = kAxes[order];
  const float sign = kSigns[order];
  float v[4];
  store(v, t.v * lanes(sign, sign, sign, 1.0f));
  AngleRange angles[3];
  for (std::size_t i = 0; i < 3; ++i) angles[i] = {limit.angles[i].middle * sign, limit.angles[i].half_width};
  const WideRotation in = nearest_in_xyz(angles, {lanes(v[axes[0]], v[axes[1]], v[axes[2]], v[3])});
  float parts[4], out[4];
  store(parts, in.v * lanes(sign, sign, sign, 1.0f));
  for (std::size_t i = 0; i < 3; ++i) out[axes[i]] = parts[i];
  out[3] = parts[3];
  return {load(out)};
}

WideRotation nearest(const JointLimit& limit, WideRotation t) {
  if (limit.kind == LimitKind::hinge) return nearest_about(kX, limit.angles[0], t);
  return limit.kind == LimitKind::cone ? nearest_in_cone(limit, t) : nearest_in_box(limit, t);
}

}  // namespace
}  // namespace marrow::ranges

namespace marrow {

BadCall check_joints(Span<const JointLimit> limits, Span<const SoaTransform> local) {
  MARROW_CHECK(holds(limits) && holds(local));
  for (const JointLimit& limit : limits) MARROW_CHECK(limit.joint / 4u < local.size);
  return {};
}

float angle_between(WideRotation a, WideRotation b) {
  const WideRotation d = conjugate(a) * b;
  const float sine_squared = squared3(d.v), w = absolute(w_lane(d));
  if (sine_squared < 0.5f) return 2.0f * sqrt(sine_squared) * asinc_for_slerp(sine_squared);
  return 3.14159265f - 2.0f * w * asinc_for_slerp(w * w);
}

WideRotation clamped(const JointLimit& limit, WideRotation q) {
  if (limit.kind == LimitKind::none) return q;
  const float squared = dot4(q.v, q.v);
  if (!has_direction(squared)) return q;
  const WideRotation unit = {q.v * (1.0f / sqrt(squared))};
  const WideRotation limit_from_parent = {load(limit.limit_from_parent)};
  const WideRotation joint_from_limit = {load(limit.joint_from_limit)};
  const WideRotation t = limit_from_parent * unit * joint_from_limit;
  const WideRotation in = ranges::nearest(limit, t);
  const f32x4 d = (conjugate(t) * in).v;  // the sine of half the angle between them
  constexpr float kLeast = 0.25f * kLimitTolerance_rad * kLimitTolerance_rad;
  if (!(squared3(d) > kLeast)) return q;
  const WideRotation out = normalised(conjugate(limit_from_parent) * in * conjugate(joint_from_limit));
  return {flip(out.v, splat(dot4(out.v, unit.v)))};
}

Status clamp_rotation(const JointLimit& limit, float (&local)[4]) {
  const WideRotation q = {load(local)};
  MARROW_REQUIRE(has_direction(dot4(q.v, q.v)));
  store(local, clamped(limit, q).v);
  return Status::ok;
}

float limit_excess(const JointLimit& limit, const float (&local)[4]) {
  const WideRotation q = {load(local)}, in = clamped(limit, q);
  if (same(q, in) || !has_direction(dot4(q.v, q.v))) return 0;
  return angle_between(normalised(q), in);
}

Status limit_pose(Span<const JointLimit> limits, Span<SoaTransform> local) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_joints(limits, local));
  for (const JointLimit& limit : limits) {
    if (limit.kind == LimitKind::none) continue;
    set_rotation(local, limit.joint, clamped(limit, wide_rotation_of(local, limit.joint)));
  }
  return Status::ok;
}

const JointLimit* find_limit(Span<const JointLimit> limits, std::uint32_t joint) {
  std::size_t first = 0, end = limits.size;
  while (first < end) {
    const std::size_t middle = first + (end - first) / 2;
    if (limits[middle].joint < joint) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first < limits.size && limits[first].joint == joint ? &limits[first] : nullptr;
}

}  // namespace marrow
