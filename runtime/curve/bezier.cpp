// Control points without keys: Bézier curves of any degree, bicubic patches.
#include <cstring>

#include "core/check.h"
#include "curve/segment.h"

namespace marrow {
namespace {

// The first point of `points` becomes the curve's at u.
void de_casteljau(float* points, std::size_t count, std::size_t n, float u) {
  const float v = 1.0f - u;
  for (std::size_t left = count; left > 1; --left) {
    for (std::size_t i = 0; i < (left - 1) * n; ++i) points[i] = v * points[i] + u * points[i + n];
  }
}

BadCall check_points(Span<const float> points, std::uint32_t n, float u, Span<float> scratch, Span<float> out) {
  MARROW_CHECK(n >= 1 && n <= kMaxComponents);
  MARROW_CHECK(holds(points) && !points.empty() && points.size % n == 0);
  MARROW_CHECK(holds(scratch, points.size));
  MARROW_CHECK(holds(out, n));
  MARROW_CHECK(is_finite(u));
  return {};
}

}  // namespace

Status bezier(Span<const float> points, std::uint32_t components, float u, Span<float> scratch, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_points(points, components, u, scratch, out));
  std::memcpy(scratch.data, points.data, sizeof(float) * points.size);
  de_casteljau(scratch.data, points.size / components, components, u);
  if (!all_finite(scratch.data, components)) return Status::bad_data;
  std::memcpy(out.data, scratch.data, sizeof(float) * components);
  return Status::ok;
}

Status bezier_rotation(Span<const float> quaternions, float u, Span<float> scratch, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_points(quaternions, 4, u, scratch, out));
  std::memcpy(scratch.data, quaternions.data, sizeof(float) * quaternions.size);
  for (std::size_t i = 4; i < quaternions.size; i += 4) chain_sign(scratch.data + i - 4, scratch.data + i);
  de_casteljau(scratch.data, quaternions.size / 4, 4, u);
  if (!normalise(scratch.data) || !all_finite(scratch.data, 4)) return Status::bad_data;
  std::memcpy(out.data, scratch.data, sizeof(float) * 4);
  return Status::ok;
}

Status bicubic_patch(PatchBasis basis, Span<const float> points, std::uint32_t components, float u, float v,
                     Span<float> out) {
  MARROW_REQUIRE(components >= 1 && components <= kMaxComponents);
  const std::size_t n = components;
  MARROW_REQUIRE(holds(points, 16 * n));
  MARROW_REQUIRE(holds(out, components));
  MARROW_REQUIRE(basis <= PatchBasis::bezier);
  MARROW_REQUIRE(is_finite(u) && is_finite(v));
  const bool through = basis == PatchBasis::catmull_rom;
  const Weights along_u = through ? catmull_rom_weights(u) : bernstein3(u);
  const Weights along_v = through ? catmull_rom_weights(v) : bernstein3(v);
  float point[kMaxComponents] = {};
  for (std::size_t c = 0; c < n; ++c) {
    float sum = 0.0f;
    for (std::size_t j = 0; j < 4; ++j) {
      const float* const row = points.data + 4 * n * j + c;
      const float* const w = along_u.w;
      sum += along_v.w[j] * (w[0] * row[0] + w[1] * row[n] + w[2] * row[2 * n] + w[3] * row[3 * n]);
    }
    point[c] = sum;
  }
  if (!all_finite(point, n)) return Status::bad_data;
  std::memcpy(out.data, point, sizeof(float) * n);
  return Status::ok;
}

}  // namespace marrow
