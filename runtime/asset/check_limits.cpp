// The rule of a joint's limit.
#include <cmath>

#include "marrow/file.h"

namespace marrow {

namespace {

bool is_unit(const float (&q)[4]) {
  const float squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return squared > 0.9999f && squared < 1.0001f;
}

bool is_limited_rate(const RateLimit& rate) {
  return rate.speed >= 0 && rate.speed < 1e18f && rate.acceleration >= 0 && rate.acceleration < 1e18f;
}

bool are_ranges(const JointLimit& limit) {
  const bool box = limit.kind == LimitKind::euler, cone = limit.kind == LimitKind::cone;
  for (int i = 0; i < 3; ++i) {
    const AngleRange& a = limit.angles[i];
    if (!(a.middle >= -1 && a.middle <= 1 && a.half_width >= 0 && a.half_width <= 1)) return false;
    const bool used = box || (cone && i > 0) || (i == 0 && limit.kind != LimitKind::none);
    if (!used && (a.middle != 0 || a.half_width != 0)) return false;
    if (cone && i > 0 && (a.middle != 0 || a.half_width > 0.9164f)) return false;  // tan(170° / 4)
  }
  const float middle = std::fabs(limit.angles[1].middle), half = limit.angles[1].half_width;
  return !box || middle + half <= 0.414215f * (1.0f - middle * half);  // tan(90° / 4), of a sum
}

}  // namespace

bool is_valid(const JointLimit& limit) {
  if (!(limit.kind <= LimitKind::euler && limit.order <= AxisOrder::zyx)) return false;
  if (limit.kind != LimitKind::euler && limit.order != AxisOrder::xyz) return false;
  return is_unit(limit.limit_from_parent) && is_unit(limit.joint_from_limit) && is_limited_rate(limit.rate) &&
         are_ranges(limit);
}

}  // namespace marrow
