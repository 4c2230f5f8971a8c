// A small dense system of equations, as the Jacobian solvers have one a step: a row for each number that a goal asks
// for.
#pragma once

#include <cstddef>

namespace marrow {

// Rows of the upper triangle, each `stride` floats: entry (i, j), i ≤ j < n, is a[i * stride + j]; entry (i, n) is the
// right-hand side. The rest need not be initialised, but must be finite.
constexpr std::size_t dense_stride(std::size_t n) {
  return (n + 1 + 3) / 4 * 4 + 4;
}

// Solves it by elimination without pivoting, as befits a symmetric matrix that damping made positive definite: L D Lᵀ.
// A pivot that rounding left below `least` is taken for `least`. a is destroyed; x: dense_stride(n).
void solve_dense(float* a, std::size_t n, float least, float* x);

}  // namespace marrow
