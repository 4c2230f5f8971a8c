#include "marrow/limits.h"

#include "core/check.h"
#include "core/mark.h"
#include "limits/joint_limit.h"
#include "limits/limit_ranges.h"
#include "math/joint.h"

namespace marrow::ranges {
namespace {

Rotation about_x(const HalfAngle& a) {
  return {a.sin, 0, 0, a.cos};
}
Rotation about_y(const HalfAngle& a) {
  return {0, a.sin, 0, a.cos};
}
Rotation about_z(const HalfAngle& a) {
  return {0, 0, a.sin, a.cos};
}

Rotation nearest_in_hinge(const JointLimit& limit, const Rotation& t) {
  const Twist twist = twist_of(t.x, t.w);
  return about_x(nearest_in(limit.angles[0], twist.angle, twist.share));
}

Rotation nearest_in_cone(const JointLimit& limit, const Rotation& t) {
  constexpr float kLeast = 1e-6f;  // a cone may be flat
  const float ry = limit.angles[1].half_width > kLeast ? limit.angles[1].half_width : kLeast;
  const float rz = limit.angles[2].half_width > kLeast ? limit.angles[2].half_width : kLeast;
  const Rotation swing = t * conjugate(about_x(twist_of(t.x, t.w).angle));
  const float k = 1.0f / (1.0f + (swing.w > 0 ? swing.w : 0.0f));
  Swing s = {swing.y * k, swing.z * k};
  const float squared = s.y * s.y + s.z * s.z, widest = ry > rz ? ry : rz;
  float share = 1;
  const float y = s.y * rz, z = s.z * ry, border = ry * rz;
  if (y * y + z * z > border * border) {
    s = nearest_on_ellipse(s, ry, rz);
    share = fade_out(sqrt(squared), widest, 1.0f);
  }
  s = {s.y * share, s.z * share};
  const float size = s.y * s.y + s.z * s.z, scale = 1.0f / (1.0f + size);
  const Rotation in = {0, 2.0f * s.y * scale, 2.0f * s.z * scale, (1.0f - size) * scale};
  // Of the twists the nearest with this swing.
  const Rotation rest = conjugate(in) * t;
  const Twist left = twist_of(rest.x, rest.w);
  return in * about_x(nearest_in(limit.angles[0], left.angle, left.share));
}

// Half of an angle from (a multiple of) the sine and cosine of the whole.
HalfAngle half_of(float sin, float cos) {
  const float size = sqrt(sin * sin + cos * cos);
  if (size < 1e-12f) return {};
  const HalfAngle half =
      cos > 0 ? HalfAngle{sin, size + cos} : HalfAngle{std::copysign(size - cos, sin), absolute(sin)};
  const float k = 1.0f / sqrt(half.sin * half.sin + half.cos * half.cos);
  return {half.sin * k, half.cos * k};
}

// In t = Rx Ry Rz the second and third angle are read off; near 90° of the second, where the third is about to be lost,
// it goes to the middle of its range. Then each in turn is the nearest, given the other two.
Rotation nearest_in_xyz(const AngleRange (&angles)[3], const Rotation& t) {
  const float sin_z = 2.0f * (t.w * t.z - t.x * t.y), cos_z = t.w * t.w + t.x * t.x - t.y * t.y - t.z * t.z;
  const HalfAngle second = half_of(2.0f * (t.w * t.y + t.x * t.z), sqrt(sin_z * sin_z + cos_z * cos_z));
  constexpr float kQuarterTurn = 0.41421356f;  // as the tangent of a quarter
  const float most = absolute(angles[1].middle), half = angles[1].half_width;
  const float widest = (most + half) / (1.0f - most * half);
  const float share =
      widest < kQuarterTurn - 1e-5f ? fade_out(absolute(second.sin) / (1.0f + second.cos), widest, kQuarterTurn) : 1.0f;
  const Rotation y0 = about_y(nearest_in(angles[1], second, 1.0f));
  const Rotation z0 = about_z(nearest_in(angles[2], half_of(sin_z, cos_z), share));
  const Rotation for_x = t * conjugate(y0 * z0);
  const Twist x = twist_of(for_x.x, for_x.w);
  const Rotation x1 = about_x(nearest_in(angles[0], x.angle, x.share));
  const Rotation for_z = conjugate(x1 * y0) * t;
  const Twist z = twist_of(for_z.z, for_z.w);
  const Rotation z1 = about_z(nearest_in(angles[2], z.angle, z.share));
  const Rotation for_y = conjugate(x1) * t * conjugate(z1);
  const Twist y = twist_of(for_y.y, for_y.w);
  return x1 * about_y(nearest_in(angles[1], y.angle, y.share)) * z1;
}

// Axes renamed so that the order is xyz. Where that mirrors them, rotations turn the other way, and so do the ranges.
Rotation nearest_in_box(const JointLimit& limit, const Rotation& t) {
  constexpr std::uint8_t kAxes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  constexpr float kSigns[6] = {1, -1, -1, 1, 1, -1};
  const auto order = static_cast<std::size_t>(limit.order);
  const std::uint8_t(&axes)[3] = kAxes[order];
  const float sign = kSigns[order];
  const float v[3] = {t.x * sign, t.y * sign, t.z * sign};
  AngleRange angles[3];
  for (std::size_t i = 0; i < 3; ++i) angles[i] = {limit.angles[i].middle * sign, limit.angles[i].half_width};
  const Rotation in = nearest_in_xyz(angles, {v[axes[0]], v[axes[1]], v[axes[2]], t.w});
  const float parts[3] = {in.x * sign, in.y * sign, in.z * sign};
  float out[3] = {};
  for (std::size_t i = 0; i < 3; ++i) out[axes[i]] = parts[i];
  return {out[0], out[1], out[2], in.w};
}

Rotation nearest(const JointLimit& limit, const Rotation& t) {
  if (limit.kind == LimitKind::hinge) return nearest_in_hinge(limit, t);
  return limit.kind == LimitKind::cone ? nearest_in_cone(limit, t) : nearest_in_box(limit, t);
}

}  // namespace
}  // namespace marrow::ranges

namespace marrow {

float angle_between(const Rotation& a, const Rotation& b) {
  const Rotation d = conjugate(a) * b;
  const float sine_squared = dot(axis_part(d), axis_part(d)), w = absolute(d.w);
  if (sine_squared < 0.5f) return 2.0f * sqrt(sine_squared) * asinc_for_slerp(sine_squared);
  return 3.14159265f - 2.0f * w * asinc_for_slerp(w * w);
}

Rotation clamped(const JointLimit& limit, const Rotation& q) {
  if (limit.kind == LimitKind::none) return q;
  const float squared = dot(q, q);
  if (!has_direction(squared)) return q;
  const float k = 1.0f / sqrt(squared);
  const Rotation unit = q * k;
  const Rotation limit_from_parent = rotation(limit.limit_from_parent);
  const Rotation joint_from_limit = rotation(limit.joint_from_limit);
  const Rotation t = limit_from_parent * unit * joint_from_limit;
  const Rotation in = ranges::nearest(limit, t);
  const Vector3 d = axis_part(conjugate(t) * in);  // sin of half the angle between them
  constexpr float kLeast = 0.25f * kLimitTolerance_rad * kLimitTolerance_rad;
  if (!(dot(d, d) > kLeast)) return q;
  const Rotation out = normalised(conjugate(limit_from_parent) * in * conjugate(joint_from_limit));
  return dot(out, unit) < 0 ? out * -1.0f : out;
}

Status clamp_rotation(const JointLimit& limit, float (&local)[4]) {
  const Rotation q = rotation(local);
  const float squared = dot(q, q);
  MARROW_REQUIRE(has_direction(squared));
  store(local, clamped(limit, q));
  return Status::ok;
}

float limit_excess(const JointLimit& limit, const float (&local)[4]) {
  const Rotation q = rotation(local), in = clamped(limit, q);
  const bool same = q.x == in.x && q.y == in.y && q.z == in.z && q.w == in.w;
  const float squared = dot(q, q);
  if (same || !has_direction(squared)) return 0;
  return angle_between(normalised(q), in);
}

Status limit_pose(Span<const JointLimit> limits, Span<SoaTransform> local) {
  MARROW_MARK;
  MARROW_REQUIRE(holds(limits) && holds(local));
  for (const JointLimit& limit : limits) MARROW_REQUIRE(limit.joint / 4u < local.size);
  for (const JointLimit& limit : limits) {
    if (limit.kind == LimitKind::none) continue;
    set_rotation(local, limit.joint, clamped(limit, rotation_of(local, limit.joint)));
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
