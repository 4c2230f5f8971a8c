#include "deform/fit/fit.h"

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/dense.h"
#include "deform/fit/choose_joints.h"
#include "deform/fit/solver.h"
#include "deform/fit/training.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

MatrixXd ridged(const Sums& sums, double ridge) {
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

// Animation space. Parts: vertices that may follow the same joints. Settings: ridges. Weighings: kStrengths.
class AnimationSpace final : public Basis {
 public:
  AnimationSpace(const Training& training, const Coordinates& prior, const FitOptions& options)
      : training_(training), prior_(prior), options_(options), groups_(group_by_joints(prior)) {}

  std::size_t parts() const override { return groups_.size(); }

  Part choose(std::size_t part) override {
    const Corrections eq = corrections(part);
    Part out;
    const VectorXd by_row = eq.missing.rowwise().squaredNorm();
    out.prior.resize(index(training_.examples.size()));
    for (Index i = 0; i < out.prior.size(); ++i) out.prior[i] = by_row.segment<3>(3 * i).sum();
    MatrixXd left(eq.missing.rows(), eq.missing.cols());
    for (std::size_t s = 0; s < kStrengthCount; ++s) out.chosen.push_back(best_ridge(eq, s, out.prior, left));
    return out;
  }

  void solve(std::size_t part, std::size_t strength, std::size_t ridge) override {
    const Group& group = groups_[part];
    const Corrections eq = corrections(part);
    const Fold all{0, training_.motion.first};
    const MatrixXd x =
        eq.basis * ridged(add_up(eq, training_.weights[strength], all), of_ridge_ * options_.ridges[ridge]);
    for (std::size_t i = 0; i < group.vertices.size(); ++i) {
      std::vector<Coordinate>& vertex = coordinates_[group.vertices[i]];
      for (std::size_t j = 0; j < vertex.size(); ++j)
        vertex[j].q += coordinate(group, x.col(index(i)).segment<4>(4 * index(j)), training_.diagonal_m);
    }
  }

  // Of ridges that are so many times what was chosen.
  Coordinates solution(const Chosen& chosen, double of_ridge) {
    of_ridge_ = of_ridge;
    coordinates_ = prior_;
    deform::solve(*this, chosen);
    return std::move(coordinates_);
  }

 private:
  Corrections corrections(std::size_t part) const {
    return {groups_[part], training_, prior_, options_.keep_bind_pose};
  }

  Choice best_ridge(const Corrections& eq, std::size_t strength, const VectorXd& prior, MatrixXd& left) const {
    const bool can = training_.folds.size() > 1;
    std::vector<Sums> parts;
    for (const Fold& fold : training_.folds) parts.push_back(add_up(eq, training_.weights[strength], fold));
    Sums all = parts.front();
    for (std::size_t f = 1; f < parts.size(); ++f) {
      all.normal += parts[f].normal;
      all.right += parts[f].right;
    }
    const auto held_out = [&](std::size_t r) {
      VectorXd errors(index(training_.examples.size()));
      for (std::size_t f = 0; f < parts.size(); ++f) {
        const Sums others = can ? Sums{all.normal - parts[f].normal, all.right - parts[f].right} : all;
        squared_errors(eq, training_.folds[f], ridged(others, options_.ridges[r]), left, errors);
      }
      if (training_.motion.count > 0)
        squared_errors(eq, training_.motion, ridged(all, options_.ridges[r]), left, errors);
      return errors;
    };
    const std::size_t ridges = eq.a.cols() == 0 ? 0 : can ? options_.ridges.size() : 1;
    return best_setting(prior, ridges, held_out,
                        [&](const VectorXd& errors) { return cost_of(errors, training_, strength); });
  }

  const Training& training_;
  const Coordinates& prior_;
  const FitOptions& options_;
  std::vector<Group> groups_;
  Coordinates coordinates_;
  double of_ridge_ = 1;
};

constexpr int kRounds = 8;
constexpr double kOfOwn = 0.2;
constexpr auto kOfNeighbours = static_cast<float>(1 - kOfOwn);
constexpr double kMostFarther = 1.15;

using Errors = std::vector<glm::vec3>;

// In diagonals.
Errors errors_of(const Coordinates& coordinates, const Example& example, const Errors& truth, double diagonal_m) {
  Errors out(coordinates.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    glm::dvec3 at(0);
    for (const Coordinate& c : coordinates[v]) at += example.at->pose[c.joint] * c.q;
    out[v] = glm::vec3(at / diagonal_m - example.centre - glm::dvec3(truth[v]));
  }
  return out;
}

glm::vec3 mean_of_neighbours(const Surface& surface, std::size_t v, const Errors& errors) {
  const auto around = surface.neighbours(v);
  const auto weights = surface.weights(v);
  glm::vec3 out(0);
  for (std::size_t i = 0; i < around.size(); ++i) out += errors[around[i]] * static_cast<float>(weights[i]);
  return out;
}

// Errors that go over smoothly from vertex to vertex, so that what a fit misses is no crease: fits again, eight times,
// to the truth and 0.8 of what the neighbours miss of it, as if Σ |e_u - e_v|² over edges were in the sum. solve:
// coordinates for the truths that `training` has, by kOfOwn of the ridge, which is what is left of the error itself.
// What comes out takes the place of `fitted` unless it is farther from the truth by more than 15 %. Memory: 12 bytes ·
// vertices · poses.
void even_errors(const Surface& surface, const std::function<Coordinates()>& solve, Training& training,
                 Coordinates& fitted) {
  const std::size_t count = training.motion.first;  // of the poses that are learnt
  std::vector<Errors> truths;
  for (std::size_t e = 0; e < count; ++e) truths.push_back(training.examples[e].truth);
  const auto squares_of = [&](const Coordinates& coordinates) {
    std::vector<double> squares(count, 0);
    tools::for_each_in_parallel(count, [&](std::size_t e) {
      for (const glm::vec3& error : errors_of(coordinates, training.examples[e], truths[e], training.diagonal_m))
        squares[e] += static_cast<double>(glm::dot(error, error));
    });
    double out = 0;
    for (const double s : squares) out += s;
    return out;
  };
  Coordinates now = fitted;
  for (int round = 0; round < kRounds; ++round) {
    tools::for_each_in_parallel(count, [&](std::size_t e) {
      Example& example = training.examples[e];
      const Errors errors = errors_of(now, example, truths[e], training.diagonal_m);
      for (std::size_t v = 0; v < errors.size(); ++v)
        example.truth[v] = truths[e][v] + mean_of_neighbours(surface, v, errors) * kOfNeighbours;
    });
    now = solve();
  }
  for (std::size_t e = 0; e < count; ++e) training.examples[e].truth = truths[e];
  if (squares_of(now) <= kMostFarther * kMostFarther * squares_of(fitted)) fitted = std::move(now);
}

}  // namespace

Fit fit_coordinates(const Coordinates& candidates, double diagonal_m, std::vector<TrainingPose> poses,
                    const Deformer& truth, const Deformer& reference, const FitOptions& options) {
  Training training = prepare_training(diagonal_m, poses, truth, reference, options.progress);
  if (training.folds.empty()) return {candidates, {}, 0};
  const Coordinates prior = options.weights == nullptr ? candidates
                                                       : choose_joints(candidates, *options.weights, options.is_lift,
                                                                       options.most_joints, options.unseen, training);
  AnimationSpace basis(training, prior, options);
  const Chosen chosen = choose_settings(basis, training.judged, options.most_worse, options.progress);
  Fit out{basis.solution(chosen, 1), chosen.quality, 0};
  if (chosen.shipped > 0)
    out.rms = std::sqrt(chosen.squares / static_cast<double>(chosen.shipped) / static_cast<double>(prior.size()));
  if (options.even_over != nullptr)
    even_errors(
        *options.even_over, [&] { return basis.solution(chosen, kOfOwn); }, training, out.coordinates);
  return out;
}

}  // namespace marrow::deform
