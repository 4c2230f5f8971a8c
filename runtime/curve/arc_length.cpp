// A path → its length table; a distance → the time that is there.
#include "core/builtins.h"
#include "core/check.h"
#include "curve/segment.h"

namespace marrow {
namespace {

float speed(const Segment& segment, float u) {
  float slope[kMaxComponents];
  segment_slope(segment, u, slope);
  return square_root(dot(slope, slope, segment.components));
}

// Three-point Gauss-Legendre quadrature of the speed over `width` around `centre`, exact to degree 5.
float stretch_length(const Segment& segment, float centre, float width) {
  constexpr float kNode = 0.387298335f;  // √(3/5) / 2
  const float ends = speed(segment, centre - kNode * width) + speed(segment, centre + kNode * width);
  return width * (5.0f * ends + 8.0f * speed(segment, centre)) / 18.0f;
}

bool has_length(const Curve& curve) {
  return !curve.rotation && curve.kind != CurveKind::step;
}

BadCall check_table(const Curve& curve, std::uint32_t steps, Span<const float> lengths) {
  MARROW_CHECK(steps >= 1);
  MARROW_CHECK(holds(lengths));
  // Divided, not multiplied: no number of steps overflows.
  MARROW_CHECK(lengths.size >= 1 && (lengths.size - 1) / steps >= curve.times_s.size - 1);
  return {};
}

// How far `x` is on the way, 0 … 1: also in a table that make_arc_length() has not written.
float part_of(float from, float to, float x) {
  const float part = (x - from) / (to - from);
  return part > 0.0f ? (part < 1.0f ? part : 1.0f) : 0.0f;
}

}  // namespace

Status make_arc_length(const Curve& curve, std::uint32_t steps, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_counts(curve));
  if (!has_length(curve)) return Status::unsupported;
  MARROW_REQUIRE_GOOD(check_table(curve, steps, out));
  const float width = 1.0f / static_cast<float>(steps);
  double sum = 0.0;  // so that many short steps do not round away
  float* length = out.data;
  *length++ = 0.0f;
  for (std::size_t key = 0; key + 1 < curve.times_s.size; ++key) {
    const Segment segment = make_segment(curve, key);
    for (std::uint32_t step = 0; step < steps; ++step) {
      sum += static_cast<double>(stretch_length(segment, (static_cast<float>(step) + 0.5f) * width, width));
      *length++ = static_cast<float>(sum);
    }
  }
  return is_finite(static_cast<float>(sum)) ? Status::ok : Status::bad_data;
}

Status time_at_distance(const Curve& curve, const ArcLength& table, float distance, float& time_s) {
  MARROW_REQUIRE_GOOD(check_counts(curve));
  if (!has_length(curve)) return Status::unsupported;
  MARROW_REQUIRE_GOOD(check_table(curve, table.steps, table.lengths));
  MARROW_REQUIRE(distance == distance);
  const std::size_t last = arc_length_count(curve.times_s.size, table.steps) - 1;
  const float* const lengths = table.lengths.data;
  if (distance < 0.0f) distance = 0.0f;
  if (!(distance < lengths[last])) {
    time_s = curve.times_s[curve.times_s.size - 1];
    return Status::ok;
  }
  const std::size_t step = find_interval(lengths, last, distance);
  const float part = part_of(lengths[step], lengths[step + 1], distance);
  const std::size_t key = step / table.steps;
  const float u = (static_cast<float>(step % table.steps) + part) / static_cast<float>(table.steps);
  time_s = (1.0f - u) * curve.times_s[key] + u * curve.times_s[key + 1];
  return Status::ok;
}

}  // namespace marrow
