// Animation-space coordinates of one block of four vertices.
#pragma once

#include "math/f32x4.h"

namespace marrow {

// skin, residual, q: the block's part of each stream; residual may be null. k: the run's influences.
inline void write_as_block(const float* skin, const float* residual, std::uint32_t k, float* q) {
  const f32x4 v[3] = {load(skin), load(skin + 4), load(skin + 8)};
  skin += 12;
  f32x4 sum[3] = {v[0], v[1], v[2]};
  float* const to_sum = q;
  q += 12;
  for (std::uint32_t j = 0; j < k; ++j) {
    if (residual != nullptr)
      for (int i = 0; i < 3; ++i) sum[i] = sum[i] + load(residual + 4 * i);
    if (j + 1 < k) {
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

}  // namespace marrow
