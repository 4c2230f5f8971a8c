// Matrices of any size. A decomposition takes seconds to compile, so all files share these.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace marrow::deform {

inline Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

// x of normal x = right by LDLT. normal: n × n, symmetric, positive semidefinite; right: n rows. O(n³).
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right);
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& normal, const Eigen::MatrixXd& right);
Eigen::Vector4d solve_symmetric(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right);

// The inverse of a positive definite matrix.
Eigen::MatrixXd inverse_of_symmetric(const Eigen::MatrixXd& normal);
Eigen::Matrix4d inverse_of_symmetric(const Eigen::Matrix4d& normal);

// Of a symmetric matrix, by ascending value; a column a vector, of length 1.
struct Eigenvectors {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
Eigenvectors eigenvectors_of_symmetric(const Eigen::MatrixXd& matrix);

}  // namespace marrow::deform
