#include "ik/dense.h"

#include "math/f32x4.h"

namespace marrow {

// All inner loops run along rows, four floats at a time, and so into the rows' padding.
void solve_dense(float* a, std::size_t n, float least, float* x) {
  const std::size_t stride = dense_stride(n);
  for (std::size_t k = 0; k < n; ++k) {
    float* const pivot = a + k * stride;
    if (!(pivot[k] > least)) pivot[k] = least;
    const float inverse = 1.0f / pivot[k];
    for (std::size_t i = k + 1; i < n; ++i) {
      if (pivot[i] == 0) continue;  // goals that share no joint
      const f32x4 factor = splat(pivot[i] * inverse);
      float* const row = a + i * stride;
      for (std::size_t j = i; j <= n; j += 4) store(row + j, load(row + j) - factor * load(pivot + j));
    }
    pivot[k] = inverse;
  }
  for (std::size_t i = n; i < stride; ++i) x[i] = 0;
  x[n] = -1;  // times the right-hand side
  for (std::size_t k = n; k-- > 0;) {
    const float* const row = a + k * stride;
    f32x4 sum = splat(0.0f);
    for (std::size_t j = k + 1; j <= n; j += 4) sum = sum + load(row + j) * load(x + j);
    float s[4];
    store(s, sum);
    x[k] = (s[0] + s[1] + (s[2] + s[3])) * -row[k];
  }
}

}  // namespace marrow
