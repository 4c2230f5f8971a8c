#include "deform/elastic/factor.h"

#include <Eigen/SparseCholesky>

#include "math/f32x4.h"

namespace marrow::deform {

Factor::Factor(std::size_t size, const std::vector<MatrixEntry>& entries) : order_(size) {
  using Matrix = Eigen::SparseMatrix<double>;
  if (size == 0) return;
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size());
  for (const MatrixEntry& e : entries)
    triplets.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.value);
  Matrix matrix(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> found(matrix);
  const Matrix& lower = found.matrixL().nestedExpression();
  for (std::size_t i = 0; i < size; ++i)
    order_[i] = static_cast<std::uint32_t>(found.permutationP().indices()[static_cast<Eigen::Index>(i)]);
  for (Eigen::Index column = 0; column < lower.cols(); ++column) {
    first_.push_back(static_cast<std::uint32_t>(row_.size()));
    for (Matrix::InnerIterator i(lower, column); i; ++i) {
      if (i.row() == column) continue;
      row_.push_back(static_cast<std::uint32_t>(i.row()));
      value_.push_back(static_cast<float>(i.value()));
    }
    over_diagonal_.push_back(static_cast<float>(1 / found.vectorD()[column]));
  }
  first_.push_back(static_cast<std::uint32_t>(row_.size()));
}

void Factor::solve(std::span<Four> x) const {
  std::vector<Four> y(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) y[order_[i]] = x[i];
  const auto at = [&](std::size_t i) { return y[i].v; };
  for (std::size_t c = 0; c < y.size(); ++c) {
    const f32x4 known = load_aligned(at(c));
    for (std::uint32_t e = first_[c]; e < first_[c + 1]; ++e)
      store(at(row_[e]), load_aligned(at(row_[e])) - known * splat(value_[e]));
  }
  for (std::size_t c = y.size(); c-- > 0;) {
    // Two sums, so that the processor need not wait for one addition before it begins the next.
    f32x4 even = load_aligned(at(c)) * splat(over_diagonal_[c]), odd = splat(0.0f);
    std::uint32_t e = first_[c];
    for (; e + 1 < first_[c + 1]; e += 2) {
      even = even - load_aligned(at(row_[e])) * splat(value_[e]);
      odd = odd - load_aligned(at(row_[e + 1])) * splat(value_[e + 1]);
    }
    if (e < first_[c + 1]) even = even - load_aligned(at(row_[e])) * splat(value_[e]);
    store(at(c), even + odd);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) x[i] = y[order_[i]];
}

}  // namespace marrow::deform
