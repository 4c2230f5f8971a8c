#include "deform/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/parallel.h"
#include "deform/dense.h"
#include "deform/fit/choose_joints.h"
#include "deform/fit/even_errors.h"
#include "deform/fit/training.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kKeepPrior = std::numeric_limits<double>::infinity();

// Columns perpendicular to (1, …, 1) and each other, unit: Helmert's.
MatrixXd differences(Index n) {
  MatrixXd h = MatrixXd::Zero(n, n - 1);
  for (Index c = 0; c + 1 < n; ++c) {
    const double scale = 1 / std::sqrt(static_cast<double>((c + 1) * (c + 2)));
    for (Index r = 0; r <= c; ++r) h(r, c) = scale;
    h(c + 1, c) = -static_cast<double>(c + 1) * scale;
  }
  return h;
}

// Unknown 4 j + c of joint j; the w always sum to 0, the others only if the bind pose is to stay.
MatrixXd constraint_basis(Index joints, bool keep_bind_pose) {
  const MatrixXd bound = differences(joints), free = MatrixXd::Identity(joints, joints);
  const Index width = 3 * (keep_bind_pose ? joints - 1 : joints) + joints - 1;
  MatrixXd out = MatrixXd::Zero(4 * joints, width);
  Index column = 0;
  for (Index c = 0; c < 4; ++c) {
    const MatrixXd& part = c == 3 || keep_bind_pose ? bound : free;
    for (Index i = 0; i < part.cols(); ++i, ++column)
      for (Index j = 0; j < joints; ++j) out(4 * j + c, column) = part(j, i);
  }
  return out;
}

// Equations of what is missing from the prior, within the constraints.
struct Corrections {
  MatrixXd basis, a, missing;

  Corrections(const Group& group, const Training& training, const Coordinates& prior, bool keep_bind_pose)
      : basis(constraint_basis(index(group.joints.size()), keep_bind_pose)) {
    const Equations eq(group, training, training.examples.size());
    missing = eq.truth - eq.a * unknowns(group, prior, training.diagonal_m);
    a = eq.a * basis;
  }
};

// As cross-validation found, a strength.
struct Validated {
  double ridge[kStrengthCount];
  VectorXd held_out[kStrengthCount];  // squared errors, a pose
  VectorXd prior;                     // the same of the prior
};

struct Sums {
  MatrixXd normal, right;
};

// Rows of poses that are learnt.
MatrixXd::ConstRowsBlockXpr rows_of(const MatrixXd& a, const Fold& fold) {
  return a.middleRows(3 * index(fold.first), 3 * index(fold.count));
}

Sums add_up(const Corrections& eq, const VectorXd& weights, const Fold& fold) {
  const Index first = 3 * index(fold.first), rows = 3 * index(fold.count);
  const auto a = eq.a.middleRows(first, rows);
  const MatrixXd weighted = weights.segment(first, rows).asDiagonal() * a;
  return {a.transpose() * weighted, weighted.transpose() * eq.missing.middleRows(first, rows)};
}

MatrixXd solve(const Sums& sums, double ridge) {
  MatrixXd normal = sums.normal;
  normal.diagonal().array() += ridge;
  return solve_symmetric(normal, sums.right);
}

// Squared errors of a fold, written a pose. `left` is memory for what x leaves of the equations: a third of a sanitized
// fit, and a thirtieth of an optimised one, went into having it anew for each fold and ridge.
void squared_errors(const Corrections& eq, const Fold& fold, const MatrixXd& x, MatrixXd& left, VectorXd& out) {
  auto rows = left.middleRows(3 * index(fold.first), 3 * index(fold.count));
  rows.noalias() = rows_of(eq.a, fold) * x;
  rows -= rows_of(eq.missing, fold);
  const VectorXd by_row = rows.rowwise().squaredNorm();
  for (std::size_t i = 0; i < fold.count; ++i) out[index(fold.first + i)] = by_row.segment<3>(3 * index(i)).sum();
}

// What choices are judged by.
double cost_of(const VectorXd& errors, const Training& training, std::size_t strength) {
  double out = 0;
  for (std::size_t e = 0; e < training.motion.first; ++e)
    out += training.weights[strength][3 * index(e)] * errors[index(e)];
  return out + training.motion_weights[strength] * errors.tail(index(training.motion.count)).sum();
}

void cross_validate(const Corrections& eq, const Training& training, const FitOptions& options, Validated& group) {
  const bool can = training.folds.size() > 1;
  const VectorXd by_row = eq.missing.rowwise().squaredNorm();
  group.prior.resize(index(training.examples.size()));
  for (Index i = 0; i < group.prior.size(); ++i) group.prior[i] = by_row.segment<3>(3 * i).sum();
  MatrixXd left(eq.missing.rows(), eq.missing.cols());
  for (std::size_t s = 0; s < kStrengthCount; ++s) {
    const VectorXd& weights = training.weights[s];
    std::vector<Sums> parts;
    for (const Fold& fold : training.folds) parts.push_back(add_up(eq, weights, fold));
    Sums all = parts.front();
    for (std::size_t f = 1; f < parts.size(); ++f) {
      all.normal += parts[f].normal;
      all.right += parts[f].right;
    }
    group.held_out[s] = group.prior;
    group.ridge[s] = kKeepPrior;
    double least = cost_of(group.prior, training, s);
    if (eq.a.cols() == 0) continue;
    for (std::size_t r = 0; r < (can ? options.ridges.size() : 1); ++r) {
      VectorXd errors(index(training.examples.size()));
      for (std::size_t f = 0; f < parts.size(); ++f) {
        const Sums others = can ? Sums{all.normal - parts[f].normal, all.right - parts[f].right} : all;
        squared_errors(eq, training.folds[f], solve(others, options.ridges[r]), left, errors);
      }
      if (training.motion.count > 0) squared_errors(eq, training.motion, solve(all, options.ridges[r]), left, errors);
      const double error = cost_of(errors, training, s);
      if (!(error < least)) continue;
      least = error;
      group.ridge[s] = options.ridges[r];
      group.held_out[s] = errors;
    }
  }
}

struct HeldOut {
  FitQuality quality;
  double squares = 0;  // of all vertices in all shipped poses
  std::size_t poses = 0;
};

HeldOut held_out(const std::vector<Validated>& groups, const Training& training, std::size_t strength) {
  VectorXd errors = VectorXd::Zero(index(training.examples.size()));
  for (const Validated& group : groups) errors += group.held_out[strength];
  double ours = 0, reference = 0;
  std::size_t worse = 0, shipped = 0;
  for (std::size_t e = 0; e < training.examples.size(); ++e) {
    if (!training.examples[e].at->shipped) continue;
    ++shipped;
    ours += errors[index(e)];
    reference += training.examples[e].reference_error;
    worse += errors[index(e)] > training.examples[e].reference_error;
  }
  if (!(reference > 0)) return {};
  return {{std::sqrt(ours / reference), static_cast<double>(worse) / static_cast<double>(shipped)}, ours, shipped};
}

// What counts is the error, and dearly the share of poses beyond `most_worse` that become worse.
std::size_t best_strength(const std::vector<Validated>& groups, const Training& training, const FitOptions& options,
                          HeldOut& best) {
  std::size_t chosen = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < kStrengthCount; ++s) {
    const HeldOut h = held_out(groups, training, s);
    const double cost = h.quality.share * (1 + 2 * std::max(0.0, h.quality.worse_share - options.most_worse));
    if (cost >= least) continue;
    least = cost;
    chosen = s;
    best = h;
  }
  return chosen;
}

// In poses that are not learnt: until none is worse than the reference, the group that adds most keeps the prior.
void keep_motion(const Training& training, std::size_t strength, std::vector<Validated>& groups) {
  VectorXd errors = VectorXd::Zero(index(training.examples.size()));
  for (const Validated& group : groups) errors += group.held_out[strength];
  for (std::size_t e = training.motion.first; e < training.examples.size(); ++e) {
    const Index at = index(e);
    while (errors[at] > training.examples[e].reference_error * (1 - 1e-6)) {
      const auto added = [&](const Validated& g) { return g.held_out[strength][at] - g.prior[at]; };
      const auto worst = std::ranges::max_element(groups, {}, added);
      if (worst == groups.end() || !(added(*worst) > 0)) break;
      errors += worst->prior - worst->held_out[strength];
      worst->held_out[strength] = worst->prior;
      worst->ridge[strength] = kKeepPrior;
    }
  }
}

void write_solution(const Group& group, const Corrections& eq, const Training& training, std::size_t strength,
                    double ridge, Coordinates& out) {
  const Fold all{0, training.motion.first};
  const MatrixXd x = eq.basis * solve(add_up(eq, training.weights[strength], all), ridge);
  for (std::size_t i = 0; i < group.vertices.size(); ++i) {
    std::vector<Coordinate>& vertex = out[group.vertices[i]];
    for (std::size_t j = 0; j < vertex.size(); ++j)
      vertex[j].q += coordinate(group, x.col(index(i)).segment<4>(4 * index(j)), training.diagonal_m);
  }
}

}  // namespace

Fit fit_coordinates(const Coordinates& candidates, double diagonal_m, std::vector<TrainingPose> poses,
                    const Deformer& truth, const Deformer& reference, const FitOptions& options) {
  Training training = prepare_training(diagonal_m, poses, truth, reference, options.progress);
  if (training.folds.empty()) return {candidates, {}, 0};
  const Coordinates prior = options.weights == nullptr ? candidates
                                                       : choose_joints(candidates, *options.weights, options.is_lift,
                                                                       options.most_joints, options.unseen, training);
  const std::vector<Group> groups = group_by_joints(prior);
  std::vector<Validated> validated(groups.size());
  Steps steps(options.progress, groups.size());
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    cross_validate(Corrections(groups[g], training, prior, options.keep_bind_pose), training, options, validated[g]);
    steps.one_more();
  });
  Fit out;
  HeldOut best;
  const std::size_t strength = best_strength(validated, training, options, best);
  keep_motion(training, strength, validated);
  best = held_out(validated, training, strength);
  out.quality = best.quality;
  if (best.poses > 0)
    out.rms = std::sqrt(best.squares / static_cast<double>(best.poses) / static_cast<double>(prior.size()));
  const auto solution = [&](double of_ridge) {
    Coordinates solved = prior;
    tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
      const double ridge = validated[g].ridge[strength];
      if (ridge == kKeepPrior) return;
      write_solution(groups[g], Corrections(groups[g], training, prior, options.keep_bind_pose), training, strength,
                     of_ridge * ridge, solved);
    });
    return solved;
  };
  out.coordinates = solution(1);
  if (options.even_over != nullptr) {
    const auto again = [&] { return solution(kOfOwn); };
    even_errors(*options.even_over, again, training, out.coordinates);
  }
  return out;
}

}  // namespace marrow::deform
