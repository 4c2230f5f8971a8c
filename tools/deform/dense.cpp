#include "deform/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace marrow::deform {

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right) {
  return normal.ldlt().solve(right);
}

Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& normal, const Eigen::MatrixXd& right) {
  return normal.ldlt().solve(right);
}

Eigen::Vector4d solve_symmetric(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right) {
  return normal.ldlt().solve(right);
}

Eigen::MatrixXd inverse_of_symmetric(const Eigen::MatrixXd& normal) {
  return normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
}

Eigen::Matrix4d inverse_of_symmetric(const Eigen::Matrix4d& normal) {
  return normal.inverse();
}

Eigenvectors eigenvectors_of_symmetric(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace marrow::deform
