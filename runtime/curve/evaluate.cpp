// Keys → value or velocity at a time.
#include <cstring>

#include "core/check.h"
#include "curve/segment.h"

namespace marrow {
namespace {

// The floats of one key's value.
const float* key_value(const Curve& curve, std::size_t key) {
  std::size_t point = key;
  if (curve.kind == CurveKind::hermite) point = 3 * key + 1;
  if (curve.kind == CurveKind::quadratic_bezier) point = 2 * key;
  if (curve.kind == CurveKind::cubic_bezier) point = 3 * key;
  return curve.values.data + point * curve.components;
}

void copy_key(const Curve& curve, std::size_t key, Span<float> out) {
  std::memcpy(out.data, key_value(curve, key), sizeof(float) * curve.components);
}

constexpr float kFarthestKey = 1e18f;  // no blend of four of them, or square, is infinite

bool is_far(const float* values, std::size_t count) {
  return !all_within(values, count, -kFarthestKey, kFarthestKey);
}

// Hermite tangents over the longest interval between two keys, which is more than it has to be.
bool are_tangents_far(const Curve& curve) {
  float longest_s = 0.0f;
  for (std::size_t i = 1; i < curve.times_s.size; ++i) {
    const float span_s = curve.times_s[i] - curve.times_s[i - 1];
    longest_s = span_s > longest_s ? span_s : longest_s;
  }
  const std::size_t n = curve.components;
  for (std::size_t i = 0; i < 3 * n * curve.times_s.size; ++i) {
    const bool is_value = i / n % 3 == 1;
    if (!is_value && !within(curve.values[i] * longest_s, -kFarthestKey, kFarthestKey)) return true;
  }
  return false;
}

}  // namespace

BadCall check_counts(const Curve& curve) {
  MARROW_CHECK(curve.kind <= CurveKind::centripetal);
  MARROW_CHECK(curve.components >= 1 && curve.components <= kMaxComponents);
  MARROW_CHECK(!curve.rotation || curve.components == 4);
  MARROW_CHECK(holds(curve.times_s) && !curve.times_s.empty());
  MARROW_CHECK(holds(curve.values, curve_value_count(curve.kind, curve.components, curve.times_s.size)));
  return {};
}

Status check_curve(const Curve& curve) {
  MARROW_REQUIRE_GOOD(check_counts(curve));
  const std::size_t key_count = curve.times_s.size;
  if (!all_finite(curve.times_s.data, key_count)) return Status::bad_data;
  // The first interval may be too long for a float although its ends are not.
  if (!is_finite(curve.times_s[key_count - 1] - curve.times_s[0])) return Status::bad_data;
  for (std::size_t i = 1; i < key_count; ++i) {
    if (!(curve.times_s[i - 1] < curve.times_s[i])) return Status::bad_data;
  }
  if (is_far(curve.values.data, curve_value_count(curve.kind, curve.components, key_count))) return Status::bad_data;
  if (curve.kind == CurveKind::hermite && are_tangents_far(curve)) return Status::bad_data;
  for (std::size_t i = 0; curve.rotation && i < key_count; ++i) {
    const float* const q = key_value(curve, i);
    const float off = dot(q, q, 4) - 1.0f;
    if (!(off > -1e-3f && off < 1e-3f)) return Status::bad_data;
  }
  return Status::ok;
}

Status evaluate_curve(const Curve& curve, float time_s, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_counts(curve));
  MARROW_REQUIRE(time_s == time_s);
  MARROW_REQUIRE(holds(out, curve.components));
  if (curve.times_s.size == 1) {
    copy_key(curve, 0, out);
    return Status::ok;
  }
  const Moment m = find_moment(curve.times_s.data, curve.times_s.size, time_s);
  if (curve.kind == CurveKind::step) {
    copy_key(curve, m.key + (m.u >= 1.0f ? 1 : 0), out);
    return Status::ok;
  }
  segment_value(make_segment(curve, m.key), m.u, out.data);
  if (curve.rotation && !normalise(out.data)) copy_key(curve, m.key, out);
  return Status::ok;
}

Status curve_velocity(const Curve& curve, float time_s, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_counts(curve));
  MARROW_REQUIRE(time_s == time_s);
  MARROW_REQUIRE(holds(out, curve.components));
  if (curve.rotation) return Status::unsupported;
  const Span<const float> times_s = curve.times_s;
  float slope[kMaxComponents] = {};
  const bool rests = times_s.size == 1 || curve.kind == CurveKind::step;
  if (!rests && !(time_s < times_s[0] || times_s[times_s.size - 1] < time_s)) {
    const Moment m = find_moment(times_s.data, times_s.size, time_s);
    segment_slope(make_segment(curve, m.key), m.u, slope);
    const float span_s = times_s[m.key + 1] - times_s[m.key];  // at both ends, too
    for (std::uint32_t i = 0; i < curve.components; ++i) slope[i] /= span_s;
  }
  if (!all_finite(slope, curve.components)) return Status::bad_data;
  std::memcpy(out.data, slope, sizeof(float) * curve.components);
  return Status::ok;
}

}  // namespace marrow
