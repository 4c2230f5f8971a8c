#include "deform/pose_metric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glm/matrix.hpp>

#include "common/parallel.h"
#include "deform/dense.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRidge = 1e-8;  // of the normal matrix's diagonal

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(const Coordinates& coordinates) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const std::vector<Coordinate>& vertex : coordinates)
    for (std::size_t a = 0; a < vertex.size(); ++a)
      for (std::size_t b = a; b < vertex.size(); ++b) out.emplace(vertex[a].joint, vertex[b].joint);
  return {out.begin(), out.end()};
}

// M_iᵀ M_j.
glm::dmat4 product(const Matrix& a, const Matrix& b) {
  glm::dmat4 out;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) out[c][r] = glm::dot(a[r], b[c]);
  return out;
}

std::vector<Pose> centred(const std::vector<Pose>& poses) {
  std::vector<Pose> out;
  for (const Pose& pose : poses) {
    if (!is_finite(pose)) continue;
    glm::dvec3 mean(0);
    for (const Matrix& m : pose) mean += m[3] / static_cast<double>(pose.size());
    out.push_back(pose);
    for (Matrix& m : out.back()) m[3] -= mean;
  }
  return out;
}

double form(const glm::dvec4& a, const glm::dmat4& m, const glm::dvec4& b) {
  return glm::dot(a, m * b);
}

glm::dvec4& part_of(std::vector<Coordinate>& vertex, std::uint32_t joint) {
  return std::ranges::lower_bound(vertex, joint, {}, &Coordinate::joint)->q;
}

// How far what follows j moves, over poses, if it follows i.
double transfer(const PoseMetric& metric, const Coordinate& j, std::uint32_t i) {
  return form(j.q, metric.block(j.joint, j.joint), j.q) + form(j.q, metric.block(i, i), j.q) -
         2 * form(j.q, metric.block(j.joint, i), j.q);
}

// The joint that does j's part best, of some.
std::uint32_t heir(const PoseMetric& metric, const Coordinate& j, const std::vector<std::uint32_t>& joints,
                   double& least) {
  std::uint32_t best = joints.front();
  least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : joints) {
    if (i == j.joint) continue;
    const double cost = transfer(metric, j, i);
    if (!(cost < least)) continue;
    least = cost;
    best = i;
  }
  return best;
}

// P (p - q), a joint.
glm::dvec4 gradient(const PoseMetric& metric, std::uint32_t joint, const std::vector<Coordinate>& difference) {
  glm::dvec4 out(0);
  for (const Coordinate& c : difference) out += metric.block(joint, c.joint) * c.q;
  return out;
}

VectorXd solve(MatrixXd normal, const VectorXd& right) {
  normal.diagonal() *= 1 + kRidge;
  normal.diagonal().array() += std::numeric_limits<double>::min();
  return solve_symmetric(normal, right);
}

}  // namespace

PoseMetric::PoseMetric(const std::vector<Pose>& poses, const Coordinates& coordinates) {
  const std::vector<Pose> of = centred(poses);
  const Pairs pairs = pairs_of(coordinates);
  std::vector<glm::dmat4> sums(pairs.size(), glm::dmat4(0));
  tools::for_each_in_parallel(pairs.size(), [&](std::size_t i) {
    for (const Pose& pose : of)
      sums[i] += product(pose[pairs[i].first], pose[pairs[i].second]) / static_cast<double>(of.size());
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) blocks_.emplace(pairs[i], sums[i]);
}

glm::dmat4 PoseMetric::block(std::uint32_t i, std::uint32_t j) const {
  return i <= j ? blocks_.at({i, j}) : glm::transpose(blocks_.at({j, i}));
}

double PoseMetric::squared_distance(const std::vector<Coordinate>& p, const std::vector<Coordinate>& q) const {
  std::map<std::uint32_t, glm::dvec4> sum;
  for (const Coordinate& c : p) sum.try_emplace(c.joint, glm::dvec4(0)).first->second += c.q;
  for (const Coordinate& c : q) sum.try_emplace(c.joint, glm::dvec4(0)).first->second -= c.q;
  std::vector<Coordinate> difference;
  for (const auto& [joint, d] : sum) difference.push_back({joint, d});
  double out = 0;
  for (const Coordinate& c : difference) out += glm::dot(c.q, gradient(*this, c.joint, difference));
  return std::max(out, 0.0);
}

std::vector<std::uint32_t> joints_to_keep(const PoseMetric& metric, const std::vector<Coordinate>& vertex,
                                          std::size_t most) {
  std::vector<Coordinate> merged = vertex;
  std::vector<std::uint32_t> joints = joints_of(vertex);
  while (joints.size() > most) {
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t goes = joints.back(), to = joints.front();
    for (const std::uint32_t j : joints) {
      double cost = 0;
      const std::uint32_t best = heir(metric, {j, part_of(merged, j)}, joints, cost);
      if (!(cost < least)) continue;
      least = cost;
      goes = j;
      to = best;
    }
    part_of(merged, to) += part_of(merged, goes);
    std::erase(joints, goes);
  }
  return joints;
}

std::vector<Coordinate> with_joints(const PoseMetric& metric, const std::vector<Coordinate>& vertex,
                                    const std::vector<std::uint32_t>& joints) {
  // From where each that goes has its heir: the bind pose is right, and stays so while changes sum to 0.
  std::vector<Coordinate> out, difference = vertex;
  for (const std::uint32_t j : joints) out.push_back({j, glm::dvec4(0)});
  for (const Coordinate& c : vertex) {
    double cost = 0;
    const bool kept = std::ranges::binary_search(joints, c.joint);
    part_of(out, kept ? c.joint : heir(metric, c, joints, cost)) += c.q;
  }
  for (const Coordinate& c : out) part_of(difference, c.joint) -= c.q;
  const std::size_t free = joints.size() - 1;
  if (free == 0) return out;
  MatrixXd normal(4 * static_cast<Index>(free), 4 * static_cast<Index>(free));
  VectorXd right(normal.rows());
  const std::uint32_t last = joints.back();
  for (std::size_t a = 0; a < free; ++a) {
    const glm::dvec4 g = gradient(metric, joints[a], difference) - gradient(metric, last, difference);
    for (int r = 0; r < 4; ++r) right(4 * static_cast<Index>(a) + r) = g[r];
    for (std::size_t b = 0; b < free; ++b) {
      const glm::dmat4 p = metric.block(joints[a], joints[b]) - metric.block(joints[a], last) -
                           metric.block(last, joints[b]) + metric.block(last, last);
      for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) normal(4 * static_cast<Index>(a) + r, 4 * static_cast<Index>(b) + c) = p[c][r];
    }
  }
  const VectorXd x = solve(std::move(normal), right);
  for (std::size_t a = 0; a < free; ++a)
    for (int r = 0; r < 4; ++r) {
      out[a].q[r] += x(4 * static_cast<Index>(a) + r);
      out.back().q[r] -= x(4 * static_cast<Index>(a) + r);
    }
  return out;
}

std::vector<Influence> with_joints(const PoseMetric& metric, const glm::dvec3& position,
                                   const std::vector<Influence>& influences, const std::vector<std::uint32_t>& joints) {
  const glm::dvec4 v(position, 1);
  const auto between = [&](std::uint32_t i, std::uint32_t j) { return form(v, metric.block(i, j), v); };
  for (std::vector<std::uint32_t> on = joints;;) {
    // Σ w_j = 1 with what the last leaves; the rest as above, a number a joint.
    const std::uint32_t last = on.back();
    const Index free = static_cast<Index>(on.size()) - 1;
    MatrixXd normal(free, free);
    VectorXd right(free);
    for (Index a = 0; a < free; ++a) {
      const std::uint32_t i = on[static_cast<std::size_t>(a)];
      right(a) = between(last, last) - between(i, last);
      for (const Influence& f : influences) right(a) += f.weight * (between(i, f.joint) - between(last, f.joint));
      for (Index b = 0; b < free; ++b) {
        const std::uint32_t j = on[static_cast<std::size_t>(b)];
        normal(a, b) = between(i, j) - between(i, last) - between(last, j) + between(last, last);
      }
    }
    std::vector<Influence> out;
    const VectorXd x = free > 0 ? solve(std::move(normal), right) : VectorXd();
    double left = 1;
    for (Index a = 0; a < free; ++a) {
      out.push_back({on[static_cast<std::size_t>(a)], x(a)});
      left -= x(a);
    }
    out.push_back({last, left});
    const auto least = std::ranges::min_element(out, {}, &Influence::weight);
    if (least->weight >= 0) return out;
    std::erase(on, least->joint);
  }
}

}  // namespace marrow::deform
