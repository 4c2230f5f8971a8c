#include "deform/fit/choose_joints.h"

#include <algorithm>
#include <limits>

#include "common/parallel.h"
#include "deform/dense.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr double kRidge = 1e-4;  // towards the candidates
constexpr double kLeastW = 1e-6;
constexpr double kSumOfW = 1e3;  // how strictly the w sum to 1

// The normal matrix and right sides of the weighted equations.
struct System {
  MatrixXd normal, right;
};

System make_system(const Group& group, const Coordinates& candidates, const Training& training) {
  const Equations eq(group, training);
  const VectorXd& weights = training.weights[kBalanced];
  const MatrixXd weighted = weights.asDiagonal() * eq.a;
  System out{eq.a.transpose() * weighted, weighted.transpose() * eq.truth};
  const MatrixXd prior = unknowns(group, candidates, training.diagonal_m);
  out.normal.diagonal().array() += kRidge;
  out.right += kRidge * prior;
  for (Index i = 3; i < out.normal.rows(); i += 4) {
    for (Index k = 3; k < out.normal.rows(); k += 4) out.normal(i, k) += kSumOfW;
    out.right.row(i).array() += kSumOfW;
  }
  return out;
}

// x, inverse: the solution for all joints, and the inverse of its normal matrix. Returns which joints stay.
std::vector<bool> eliminate(MatrixXd inverse, VectorXd x, const std::vector<bool>& kept, std::size_t most) {
  std::vector<bool> stays(kept.size(), true);
  for (std::size_t count = kept.size(); count > most; --count) {
    std::size_t least_of = kept.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < kept.size(); ++j) {
      if (!stays[j] || kept[j]) continue;
      const Index at = 4 * index(j);
      const Vector4d part = x.segment<4>(at);
      const double cost = part.dot(solve_symmetric(Matrix4d(inverse.block<4, 4>(at, at)), part));
      if (!(cost < least)) continue;
      least = cost;
      least_of = j;
    }
    if (least_of == kept.size()) break;
    stays[least_of] = false;
    const Index at = 4 * index(least_of);
    const MatrixXd column = inverse.middleCols<4>(at);
    const Matrix4d block = inverse_of_symmetric(Matrix4d(inverse.block<4, 4>(at, at)));
    x -= (column * (block * x.segment<4>(at))).eval();
    inverse -= column * block * column.transpose();
  }
  return stays;
}

// Without any w left `vertex` becomes empty.
void keep(const std::vector<bool>& stays, std::vector<Coordinate>& vertex) {
  glm::dvec4 lost(0);
  double w = 0;
  for (std::size_t j = 0; j < vertex.size(); ++j) {
    if (stays[j]) {
      w += vertex[j].q.w;
    } else {
      lost += vertex[j].q;
    }
  }
  std::vector<Coordinate> out;
  for (std::size_t j = 0; j < vertex.size(); ++j)
    if (stays[j] && w > kLeastW) out.push_back({vertex[j].joint, vertex[j].q + lost * (vertex[j].q.w / w)});
  vertex = std::move(out);
}

}  // namespace

Coordinates choose_joints(const Coordinates& candidates, const SkinnedMesh& kept, std::size_t most,
                          const Training& training) {
  Coordinates out = candidates;
  const Coordinates lifted = lift(kept);
  const std::vector<Group> groups = group_by_joints(candidates);
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    const Group& group = groups[g];
    if (group.joints.size() <= most) return;
    const System system = make_system(group, candidates, training);
    const MatrixXd inverse = inverse_of_symmetric(system.normal);
    const MatrixXd x = inverse * system.right;
    for (std::size_t i = 0; i < group.vertices.size(); ++i) {
      const std::uint32_t v = group.vertices[i];
      std::vector<bool> is_kept;
      for (const std::uint32_t j : group.joints)
        is_kept.push_back(std::ranges::find(kept.influences[v], j, &Influence::joint) != kept.influences[v].end());
      keep(eliminate(inverse, x.col(index(i)), is_kept, most), out[v]);
      if (out[v].empty()) out[v] = lifted[v];
    }
  });
  return out;
}

}  // namespace marrow::deform
