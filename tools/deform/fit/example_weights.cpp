#include "deform/fit/example_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kRankThreshold = 1e-9;  // of the largest pivot
constexpr double kNothingLeft = 1e-12;   // of weights of 1

MatrixXd matrix_of(const auto& rows) {
  MatrixXd out(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()));
  for (Index r = 0; r < out.rows(); ++r)
    for (Index c = 0; c < out.cols(); ++c)
      out(r, c) = static_cast<double>(rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
  return out;
}

std::vector<std::vector<double>> rows_of(const MatrixXd& m) {
  std::vector<std::vector<double>> out(static_cast<std::size_t>(m.rows()));
  for (Index r = 0; r < m.rows(); ++r)
    for (Index c = 0; c < m.cols(); ++c) out[static_cast<std::size_t>(r)].push_back(m(r, c));
  return out;
}

double spline(double x) {
  if (x < 1) return x * x * (x / 2 - 1) + 2.0 / 3;
  const double left = 2 - x;
  return x < 2 ? left * left * left / 6 : 0;
}

double distance(const MatrixXd& places, Index a, Index b) {
  double squared = 0;
  for (Index d = 0; d < places.cols(); ++d) squared += (places(a, d) - places(b, d)) * (places(a, d) - places(b, d));
  return std::sqrt(squared);
}

// As the runtime has it, so that what is solved for is what will be evaluated.
float inverse_width(const MatrixXd& places, Index example) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Index other = 0; other < places.rows(); ++other)
    if (other != example) nearest = std::min(nearest, distance(places, example, other));
  return places.rows() > 1 ? static_cast<float>(1 / nearest) : 1.0f;
}

}  // namespace

std::optional<ExampleFunctions> solve_examples(const std::vector<std::vector<float>>& places,
                                               const std::vector<std::vector<double>>& values) {
  const MatrixXd p = matrix_of(places), v = matrix_of(values);
  const Eigen::RowVectorXd mean_p = p.colwise().mean(), mean_v = v.colwise().mean();
  ExampleFunctions out;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> fit;
  fit.setThreshold(kRankThreshold);
  fit.compute(p.rowwise() - mean_p);
  out.spanned = static_cast<std::size_t>(fit.rank());
  MatrixXd linear(p.cols() + 1, v.cols());
  linear.bottomRows(p.cols()) = fit.solve(v.rowwise() - mean_v);
  linear.row(0) = mean_v - mean_p * linear.bottomRows(p.cols());
  const MatrixXd left = v - ((p * linear.bottomRows(p.cols())).rowwise() + linear.row(0));

  MatrixXd radial(p.rows(), p.rows());
  for (Index k = 0; k < p.rows(); ++k) {
    out.inverse_widths.push_back(inverse_width(p, k));
    for (Index i = 0; i < p.rows(); ++i)
      radial(i, k) = spline(distance(p, i, k) * static_cast<double>(out.inverse_widths.back()));
  }
  MatrixXd shares = MatrixXd::Zero(left.rows(), left.cols());
  if (left.cwiseAbs().maxCoeff() > kNothingLeft) {
    Eigen::FullPivLU<MatrixXd> solver;
    solver.setThreshold(kRankThreshold);
    solver.compute(radial);
    if (!solver.isInvertible()) return std::nullopt;
    shares = solver.solve(left);
  }
  out.linear = rows_of(linear);
  out.radial = rows_of(shares);
  return out;
}

}  // namespace marrow::deform
