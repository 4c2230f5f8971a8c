// Shape by example: cardinal functions of a point, four targets at a time.
#include "asset/sections/examples_section.h"
#include "core/builtins.h"
#include "core/check.h"
#include "core/zone.h"
#include "math/finite.h"

namespace marrow {
namespace {

// The cubic B-spline, 0 ≤ x < 2.
float spline(float x) {
  if (x < 1.0f) return x * x * (0.5f * x - 1.0f) + (2.0f / 3.0f);
  const float left = 2.0f - x;
  return left * left * left * (1.0f / 6.0f);
}

// In widths of the example.
float distance(const float* place, const float* point, std::size_t dimensions, float inverse_width) {
  float squared = 0.0f;
  for (std::size_t d = 0; d < dimensions; ++d) {
    const float along = point[d] - place[d];
    squared += along * along;
  }
  return square_root(squared) * inverse_width;
}

BadCall check_space(const ExampleSpace& space, std::size_t weight_count) {
  const std::size_t row = format::example_row(static_cast<std::uint32_t>(space.targets.size));
  MARROW_CHECK(space.parameters.size <= kMaxExampleParameters && space.example_count <= kMaxExamples);
  MARROW_CHECK(space.targets.size <= kMaxExamples && holds(space.targets));
  MARROW_CHECK(holds(space.linear, (space.parameters.size + 1) * row));
  MARROW_CHECK(holds(space.radial, space.example_count * row));
  MARROW_CHECK(holds(space.places, space.example_count * space.parameters.size));
  MARROW_CHECK(holds(space.inverse_widths, space.example_count));
  for (const std::uint32_t target : space.targets) MARROW_CHECK(target < weight_count);
  return {};
}

}  // namespace

Status find_example_channels(const File& file, const ExampleSpace& space, const File& clips, const Clip& clip,
                             Span<std::uint32_t> out) {
  MARROW_REQUIRE(holds(space.parameters) && holds(out, space.parameters.size));
  for (std::size_t i = 0; i < space.parameters.size; ++i) {
    const std::uint32_t found = clips.find_channel(clip, file.text(space.parameters[i].name));
    out[i] = found < clip.channels.size ? found : kNoChannel;
  }
  return Status::ok;
}

Status evaluate_examples(const ExampleSpace& space, Span<const float> parameters, Span<float> weights) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_space(space, weights.size));
  MARROW_REQUIRE(holds(weights));
  const std::size_t dimensions = space.parameters.size;
  MARROW_REQUIRE(holds(parameters, dimensions) && all_finite(parameters.data, dimensions));
  const std::size_t row = format::example_row(static_cast<std::uint32_t>(space.targets.size));
  alignas(16) float sums[kMaxExamples];
  for (std::size_t t = 0; t < row; t += 4) {
    f32x4 sum = load(space.linear.data + t);
    for (std::size_t d = 0; d < dimensions; ++d)
      sum = sum + splat(parameters[d]) * load(space.linear.data + (d + 1) * row + t);
    store(sums + t, sum);
  }
  for (std::size_t k = 0; k < space.example_count; ++k) {
    const float x = distance(space.places.data + k * dimensions, parameters.data, dimensions, space.inverse_widths[k]);
    if (!(x < 2.0f)) continue;
    const f32x4 share = splat(spline(x));
    for (std::size_t t = 0; t < row; t += 4)
      store(sums + t, load_aligned(sums + t) + share * load(space.radial.data + k * row + t));
  }
  if (!all_finite(sums, space.targets.size)) return Status::bad_data;
  for (std::size_t t = 0; t < space.targets.size; ++t) weights[space.targets[t]] = sums[t];
  return Status::ok;
}

}  // namespace marrow
