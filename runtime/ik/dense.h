// A small dense system of linear equations. The Jacobian methods solve one a step, with a row for each number that a
// goal asks for.
#pragma once

#include <cstddef>

namespace marrow {

// Floats a row. The matrix is its upper triangle: entry (i, j), i ≤ j < n, is a[i * stride + j], and a[i * stride + n]
// is the right-hand side. All other floats must be finite.
constexpr std::size_t dense_stride(std::size_t n) {
  return (n + 1 + 3) / 4 * 4 + 4;
}

// Solves it by L D Lᵀ without pivoting, as the matrix is symmetric and damping makes it positive definite. A pivot that
// rounding leaves below `least` counts as `least`. a is overwritten; x has dense_stride(n) floats.
void solve_dense(float* a, std::size_t n, float least, float* x);

}  // namespace marrow
