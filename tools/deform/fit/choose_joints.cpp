#include "deform/fit/choose_joints.h"

#include <algorithm>
#include <functional>

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
  const Equations eq(group, training, training.motion.first);
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

// Of a vertex's entries those that stay.
using Stays = std::vector<bool>;

// Whether those that stay can make up a vertex's weights.
using Suffices = std::function<bool(const Stays&)>;

// x, inverse: the solution for all entries, and the inverse of its normal matrix.
Stays eliminate(MatrixXd inverse, VectorXd x, std::size_t most, double unseen, const Suffices& suffices) {
  Stays stays(static_cast<std::size_t>(x.size()) / 4, true);
  Stays is_needed(stays.size(), false);  // and always will be, as fewer stay
  for (std::size_t count = stays.size(); count > (unseen > 0 ? 1 : most); --count) {
    std::vector<std::pair<double, std::size_t>> costs;
    for (std::size_t j = 0; j < stays.size(); ++j) {
      if (!stays[j] || is_needed[j]) continue;
      const Index at = 4 * index(j);
      const Vector4d part = x.segment<4>(at);
      costs.emplace_back(part.dot(solve_symmetric(Matrix4d(inverse.block<4, 4>(at, at)), part)), j);
    }
    if (count <= most) std::erase_if(costs, [&](const auto& candidate) { return !(candidate.first < unseen); });
    std::ranges::sort(costs);
    const auto goes = std::ranges::find_if(costs, [&](const auto& candidate) {
      stays[candidate.second] = false;
      if (suffices(stays)) return true;
      stays[candidate.second] = true;
      is_needed[candidate.second] = true;
      return false;
    });
    if (goes == costs.end()) break;
    const Index at = 4 * index(goes->second);
    const MatrixXd column = inverse.middleCols<4>(at);
    const Matrix4d block = inverse_of_symmetric(Matrix4d(inverse.block<4, 4>(at, at)));
    x -= (column * (block * x.segment<4>(at))).eval();
    inverse -= column * block * column.transpose();
  }
  return stays;
}

// Without any w left `vertex` becomes empty.
void keep(const Stays& stays, std::vector<Coordinate>& vertex) {
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

std::vector<std::uint32_t> staying(const std::vector<std::uint32_t>& entries, const Stays& stays) {
  std::vector<std::uint32_t> out;
  for (std::size_t j = 0; j < entries.size(); ++j)
    if (stays[j]) out.push_back(entries[j]);
  return out;
}

// The lift over `entries`, those of no weight among them. Precondition: they suffice.
std::vector<Coordinate> lift_over(const std::vector<std::uint32_t>& entries, const std::vector<Influence>& weights,
                                  const glm::dvec3& position) {
  std::vector<Coordinate> out;
  for (const std::uint32_t entry : entries) out.push_back({entry, glm::dvec4(position, 1) * weight_of(entry, weights)});
  return out;
}

}  // namespace

Coordinates choose_joints(const Coordinates& candidates, const ClosedForm& weights, bool is_lift, std::size_t most,
                          double unseen, const Training& training) {
  Coordinates out = candidates;
  const std::vector<Group> groups = group_by_joints(candidates);
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    const Group& group = groups[g];
    if (group.joints.size() <= (unseen > 0 ? 1 : most)) return;
    const System system = make_system(group, candidates, training);
    const MatrixXd inverse = inverse_of_symmetric(system.normal);
    const MatrixXd x = inverse * system.right;
    for (std::size_t i = 0; i < group.vertices.size(); ++i) {
      const std::uint32_t v = group.vertices[i];
      const Stays stays = eliminate(inverse, x.col(index(i)), most, unseen, [&](const Stays& s) {
        return weights.weights_of(v, staying(group.joints, s)).has_value();
      });
      if (!is_lift) keep(stays, out[v]);
      if (!is_lift && !out[v].empty()) continue;
      const std::vector<std::uint32_t> entries = staying(group.joints, stays);
      out[v] = lift_over(entries, *weights.weights_of(v, entries), weights.position_of(v));
    }
  });
  return out;
}

}  // namespace marrow::deform
