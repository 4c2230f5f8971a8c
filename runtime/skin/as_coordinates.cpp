#include "core/check.h"
#include "core/zone.h"
#include "marrow/skin.h"
#include "skin/as_block.h"

namespace marrow {

std::size_t as_coordinate_count(const Geometry& geometry) {
  std::size_t count = 0;
  for (const Run& run : geometry.runs) count += (std::size_t{run.vertex_count} + 3) / 4 * (run.influences * 16 - 4);
  return count;
}

Status as_coordinates(const Geometry& geometry, Span<float> out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(out, as_coordinate_count(geometry)));
  const float* skin = geometry.skin;
  const float* residual = geometry.as_residual;
  float* q = out.data;
  for (const Run& run : geometry.runs) {
    const std::uint32_t blocks = (run.vertex_count + 3) / 4;
    for (std::uint32_t block = 0; block < blocks; ++block) {
      write_as_block(skin, residual, run.influences, q);
      skin += 4 * (run.influences + 2);
      q += 16 * run.influences - 4;
      if (residual != nullptr) residual += 16 * run.influences;
    }
  }
  return Status::ok;
}

}  // namespace marrow
