#include "core/check.h"
#include "marrow/skin.h"
#include "math/f32x4.h"

namespace marrow {

std::size_t as_coordinate_count(const Geometry& geometry) {
  std::size_t count = 0;
  for (const Run& run : geometry.runs) count += (std::size_t{run.vertex_count} + 3) / 4 * run.influences * 16;
  return count;
}

Status as_coordinates(const Geometry& geometry, Span<float> out) {
  MARROW_REQUIRE(out.size >= as_coordinate_count(geometry));
  const float* skin = geometry.skin;
  const float* residual = geometry.as_residual;
  float* q = out.data;
  for (const Run& run : geometry.runs) {
    const std::uint32_t blocks = (run.vertex_count + 3) / 4;
    for (std::uint32_t block = 0; block < blocks; ++block) {
      const f32x4 x = load(skin), y = load(skin + 4), z = load(skin + 8);
      skin += 12;
      f32x4 rest = splat(1.0f);  // what the weights so far leave for the last
      for (std::uint32_t j = 0; j < run.influences; ++j, q += 16) {
        f32x4 w = rest;
        if (j + 1 < run.influences) {
          w = load(skin);
          skin += 4;
          rest = rest - w;
        }
        f32x4 lanes[4] = {w * x, w * y, w * z, w};
        if (residual != nullptr) {
          for (int i = 0; i < 4; ++i) lanes[i] = lanes[i] + load(residual + 4 * i);
          residual += 16;
        }
        for (int i = 0; i < 4; ++i) store(q + 4 * i, lanes[i]);
      }
    }
  }
  return Status::ok;
}

}  // namespace marrow
