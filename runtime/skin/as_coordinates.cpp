#include "core/check.h"
#include "marrow/skin.h"
#include "math/f32x4.h"

namespace marrow {

std::size_t as_coordinate_count(const Geometry& geometry) {
  std::size_t count = 0;
  for (const Run& run : geometry.runs) count += (std::size_t{run.vertex_count} + 3) / 4 * (run.influences * 16 - 4);
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
      const f32x4 v[3] = {load(skin), load(skin + 4), load(skin + 8)};
      skin += 12;
      f32x4 sum[3] = {v[0], v[1], v[2]};
      float* const to_sum = q;
      q += 12;
      for (std::uint32_t j = 0; j < run.influences; ++j) {
        if (residual != nullptr)
          for (int i = 0; i < 3; ++i) sum[i] = sum[i] + load(residual + 4 * i);
        if (j + 1 < run.influences) {
          const f32x4 w = load(skin);
          f32x4 lanes[4] = {w * v[0], w * v[1], w * v[2], w};
          if (residual != nullptr)
            for (int i = 0; i < 4; ++i) lanes[i] = lanes[i] + load(residual + 4 * i);
          for (int i = 0; i < 4; ++i) store(q + 4 * i, lanes[i]);
          skin += 4;
          q += 16;
        }
        if (residual != nullptr) residual += 16;
      }
      for (int i = 0; i < 3; ++i) store(to_sum + 4 * i, sum[i]);
    }
  }
  return Status::ok;
}

}  // namespace marrow
