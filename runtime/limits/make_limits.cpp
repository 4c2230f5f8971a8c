#include "core/check.h"
#include "limits/joint_limit.h"
#include "math/rotation.h"

namespace marrow {
namespace {

constexpr float kTurn = 6.2831853f, kHalfTurn = 3.14159265f, kQuarterTurn = 1.57079633f;
// Room for rounding: how far an angle may be beyond a bound, and how far short of a whole turn a range counts as whole.
constexpr float kRounding = 1e-6f;

// tan(angle / 4), for angles of at most half a turn.
float quarter_tangent(float angle_rad) {
  const float a = 0.25f * angle_rad;
  return a * sinc_of_root(a * a) / cos_of_root(a * a);
}

bool is_direction(const float (&v)[3]) {
  const float squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  return squared > 1e-12f && squared < 1e12f;
}

bool is_rate(const RateLimit& rate) {
  return rate.speed >= 0 && rate.speed < 1e18f && rate.acceleration >= 0 && rate.acceleration < 1e18f;
}

// Sets the limit's axes: x along `axis`, y along the part of `across` that is perpendicular to it.
bool limit_axes(const LimitDescription& d, WideRotation& joint_from_limit) {
  if (!is_direction(d.axis) || !is_direction(d.across)) return false;
  const f32x4 none = splat(0.0f), x = unit3_or(to_f32x4(vector3(d.axis)), none);
  const f32x4 part = across3(unit3_or(to_f32x4(vector3(d.across)), none), x);
  if (!(squared3(part) > 1e-6f)) return false;
  // First x is turned to its place; the rest is a turn about x.
  const WideRotation to_x = shortest_arc(lanes(1.0f, 0.0f, 0.0f, 0.0f), x);
  const f32x4 y = rotate(conjugate(to_x), unit3_or(part, none));  // in the y-z plane
  const float cos = first_lane(splat_lane<1>(y)), sin = first_lane(splat_lane<2>(y));
  const WideRotation turn = {cos > -0.9f ? lanes(sin, 0, 0, 1.0f + cos) : lanes(1.0f - cos, 0, 0, sin)};
  joint_from_limit = normalised(to_x * normalised(turn));
  return true;
}

bool are_angles(const LimitDescription& d, int count) {
  for (int i = 0; i < count; ++i) {
    const float least = d.least_rad[i], most = d.most_rad[i];
    if (!(-kTurn - kRounding <= least && least <= most && most <= kTurn + kRounding)) return false;
  }
  return true;
}

bool is_swing(const LimitDescription& d, int i) {
  return d.most_rad[i] >= 0 && d.most_rad[i] <= kWidestSwing_rad && d.least_rad[i] == -d.most_rad[i];
}

}  // namespace

AngleRange angle_range(float least_rad, float most_rad) {
  const float half_width = 0.5f * (most_rad - least_rad);
  if (half_width >= kHalfTurn - kRounding) return {0, 1};
  float middle = 0.5f * (least_rad + most_rad);
  if (middle > kHalfTurn) middle -= kTurn;
  if (middle < -kHalfTurn) middle += kTurn;
  return {quarter_tangent(middle), quarter_tangent(half_width)};
}

Status make_limit(const LimitDescription& d, std::uint16_t joint, JointLimit& out) {
  JointLimit made = {};
  made.joint = joint;
  made.kind = d.kind;
  MARROW_REQUIRE(d.kind <= LimitKind::euler);
  MARROW_REQUIRE(d.order <= AxisOrder::zyx);
  MARROW_REQUIRE(is_rate(d.rate));
  made.rate = d.rate;
  const WideRotation given = {load(d.zero)};
  const float squared = dot4(given.v, given.v);
  MARROW_REQUIRE(squared > 1e-12f && squared < 1e12f);
  WideRotation joint_from_limit;
  MARROW_REQUIRE(limit_axes(d, joint_from_limit));
  if (d.kind == LimitKind::hinge || d.kind == LimitKind::cone) {
    MARROW_REQUIRE(are_angles(d, 1));
    made.angles[0] = angle_range(d.least_rad[0], d.most_rad[0]);
  }
  if (d.kind == LimitKind::cone) {
    MARROW_REQUIRE(is_swing(d, 1));
    MARROW_REQUIRE(is_swing(d, 2));
    for (int i = 1; i < 3; ++i) made.angles[i] = {0, quarter_tangent(d.most_rad[i])};
  }
  if (d.kind == LimitKind::euler) {
    MARROW_REQUIRE(are_angles(d, 3));
    MARROW_REQUIRE(-kQuarterTurn - kRounding <= d.least_rad[1] && d.most_rad[1] <= kQuarterTurn + kRounding);
    for (int i = 0; i < 3; ++i) made.angles[i] = angle_range(d.least_rad[i], d.most_rad[i]);
    made.order = d.order;
  }
  store(made.limit_from_parent, normalised(conjugate(normalised(given) * joint_from_limit)).v);
  store(made.joint_from_limit, joint_from_limit.v);
  out = made;
  return Status::ok;
}

}  // namespace marrow
