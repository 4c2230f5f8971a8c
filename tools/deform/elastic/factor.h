// A sparse matrix as factors, for many right sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace marrow::deform {

// Four numbers that are reckoned with at once: x, y and z of a place, or those of four right sides.
struct alignas(16) Four {
  float v[4] = {0, 0, 0, 0};
};

struct MatrixEntry {
  std::uint32_t row, column;
  double value;
};

// L D Lᵀ of a symmetric positive definite matrix, found in double precision by Eigen's simplicial Cholesky
// factorisation, in the order of its approximate minimum degrees, and kept in single.
class Factor {
 public:
  // entries: of the lower triangle, the diagonal among them; those in one place add up.
  Factor(std::size_t size, const std::vector<MatrixEntry>& entries);

  std::size_t size() const { return order_.size(); }
  std::size_t entries() const { return row_.size(); }
  // Four right sides become their solutions, a row each. Thread-safe. Cost: two products for each entry and side.
  void solve(std::span<Four> x) const;

 private:
  std::vector<std::uint32_t> order_;  // of a row, where it is in L
  std::vector<std::uint32_t> first_;  // of a column's entries below the diagonal, and the end
  std::vector<std::uint32_t> row_;
  std::vector<float> value_;
  std::vector<float> over_diagonal_;  // 1 / D
};

}  // namespace marrow::deform
