#include "deform/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <glm/geometric.hpp>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kKeepPrior = std::numeric_limits<double>::infinity();

// How much poses count; ε is in mean squared errors.
struct Strength {
  double power, epsilon;
};
constexpr Strength kStrengths[] = {{0, 1}, {0.5, 0.1}, {1, 0.1}, {1, 0.01}};
constexpr std::size_t kStrengthCount = std::size(kStrengths);

Index index(std::size_t i) {
  return static_cast<Index>(i);
}

// What a truth makes of a pose, seen from the prior, in diagonals; and how far the reference is off.
struct Example {
  const TrainingPose* at = nullptr;
  std::vector<glm::vec3> missing;
  double reference_error = 0;  // squares, summed
};

// Rows of one fold's poses, three a pose.
struct Fold {
  std::size_t first, count;
};

struct Training {
  std::vector<Example> examples;  // by ascending fold
  std::vector<Fold> folds;        // none is empty
  std::vector<VectorXd> weights;  // a strength: a row; they sum to one third
  double diagonal_m = 1;
};

std::vector<Example> make_examples(const Coordinates& prior, double diagonal_m, const std::vector<TrainingPose>& poses,
                                   const Deformer& truth, const Deformer& reference) {
  const Deformer from_prior = animation_space(prior);
  std::vector<Example> out(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Example& e = out[i];
    Positions now, start;
    truth(poses[i].pose, now);
    e.at = &poses[i];
    reference(poses[i].pose, start);
    for (std::size_t v = 0; v < now.size(); ++v) {
      const glm::dvec3 off = (now[v] - start[v]) / diagonal_m;
      e.reference_error += glm::dot(off, off);
    }
    from_prior(poses[i].pose, start);
    for (std::size_t v = 0; v < now.size(); ++v) e.missing.emplace_back((now[v] - start[v]) / diagonal_m);
  });
  return out;
}

VectorXd pose_weights(const std::vector<Example>& examples, const Strength& strength) {
  double mean = 0;
  for (const Example& e : examples) mean += e.reference_error / static_cast<double>(examples.size());
  VectorXd rows(3 * index(examples.size()));
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const double error = mean > 0 ? examples[i].reference_error / mean : 0.0;
    rows.segment<3>(3 * index(i)).setConstant(std::pow(1 / (error + strength.epsilon), strength.power));
  }
  return rows * (1.0 / rows.sum());
}

bool is_finite(const Example& e) {
  return std::isfinite(e.reference_error) && std::ranges::all_of(e.missing, [](const glm::vec3& m) {
           return std::isfinite(m.x) && std::isfinite(m.y) && std::isfinite(m.z);
         });
}

// Sorts `poses`.
Training prepare(const Coordinates& prior, double diagonal_m, std::vector<TrainingPose>& poses, const Deformer& truth,
                 const Deformer& reference) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const TrainingPose& a, const TrainingPose& b) { return a.fold < b.fold; });
  Training out;
  out.diagonal_m = diagonal_m;
  out.examples = make_examples(prior, diagonal_m, poses, truth, reference);
  std::erase_if(out.examples, [](const Example& e) { return !is_finite(e); });
  for (std::size_t i = 0; i < out.examples.size(); ++i) {
    if (i == 0 || out.examples[i].at->fold != out.examples[i - 1].at->fold) out.folds.push_back({i, 0});
    ++out.folds.back().count;
  }
  for (const Strength& s : kStrengths) out.weights.push_back(pose_weights(out.examples, s));
  return out;
}

// Vertices that may follow the same joints. Unknowns: for each joint x, y, z in diagonals and w, all relative to
// `origin`.
struct Group {
  std::vector<std::uint32_t> joints;
  std::vector<std::uint32_t> vertices;
  glm::dvec3 origin{0};
  // As cross-validation found, a strength.
  double ridge[kStrengthCount];
  VectorXd held_out[kStrengthCount];  // squared errors, a pose
};

std::vector<Group> group_by_joints(const Coordinates& prior) {
  std::map<std::vector<std::uint32_t>, Group> groups;
  for (std::uint32_t v = 0; v < prior.size(); ++v) {
    std::vector<std::uint32_t> joints;
    glm::dvec3 place(0);
    for (const Coordinate& c : prior[v]) {
      joints.push_back(c.joint);
      place += glm::dvec3(c.q);
    }
    Group& group = groups[joints];
    group.vertices.push_back(v);
    group.origin += place;
  }
  std::vector<Group> out;
  for (auto& [joints, group] : groups) {
    group.joints = joints;
    group.origin /= static_cast<double>(group.vertices.size());
    out.push_back(std::move(group));
  }
  return out;
}

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

// A group's equations: `a` times the unknowns is what is `missing`, a column a vertex; within the constraints.
struct Equations {
  MatrixXd basis, a, missing;

  Equations(const Group& group, const Training& training, bool keep_bind_pose)
      : basis(constraint_basis(index(group.joints.size()), keep_bind_pose)),
        a(3 * index(training.examples.size()), 4 * index(group.joints.size())),
        missing(a.rows(), index(group.vertices.size())) {
    for (std::size_t e = 0; e < training.examples.size(); ++e) {
      write_pose(group, training.examples[e].at->pose, training.diagonal_m, 3 * index(e));
      for (std::size_t i = 0; i < group.vertices.size(); ++i) {
        const glm::vec3& m = training.examples[e].missing[group.vertices[i]];
        missing.col(index(i)).segment<3>(3 * index(e)) << double{m.x}, double{m.y}, double{m.z};
      }
    }
    a = a * basis;
  }

  // A motion that all joints share has no effect, as the w sum to 0; it is taken out for precision.
  void write_pose(const Group& group, const Pose& pose, double diagonal_m, Index row) {
    glm::dvec3 mean(0);
    for (const std::uint32_t j : group.joints) mean += transform(pose[j], group.origin);
    mean /= static_cast<double>(group.joints.size());
    for (std::size_t j = 0; j < group.joints.size(); ++j) {
      const Matrix& m = pose[group.joints[j]];
      const glm::dvec3 at = (transform(m, group.origin) - mean) / diagonal_m;
      for (int r = 0; r < 3; ++r) a.row(row + r).segment<4>(4 * index(j)) << m[0][r], m[1][r], m[2][r], at[r];
    }
  }
};

struct Sums {
  MatrixXd normal, right;
};

Sums add_up(const Equations& eq, const VectorXd& weights, const Fold& fold) {
  const Index first = 3 * index(fold.first), rows = 3 * index(fold.count);
  const auto a = eq.a.middleRows(first, rows);
  const MatrixXd weighted = weights.segment(first, rows).asDiagonal() * a;
  return {a.transpose() * weighted, weighted.transpose() * eq.missing.middleRows(first, rows)};
}

MatrixXd solve(const Sums& sums, double ridge) {
  MatrixXd normal = sums.normal;
  normal.diagonal().array() += ridge;
  return normal.ldlt().solve(sums.right);
}

// Squared errors of a fold's rows, written a pose; returns their weighted sum.
double squared_errors(const Equations& eq, const VectorXd& weights, const Fold& fold, const MatrixXd& x,
                      VectorXd& out) {
  const Index first = 3 * index(fold.first), rows = 3 * index(fold.count);
  const VectorXd by_row =
      (eq.a.middleRows(first, rows) * x - eq.missing.middleRows(first, rows)).rowwise().squaredNorm();
  for (std::size_t i = 0; i < fold.count; ++i) out[index(fold.first + i)] = by_row.segment<3>(3 * index(i)).sum();
  return by_row.dot(weights.segment(first, rows));
}

void cross_validate(Group& group, const Equations& eq, const Training& training, const FitOptions& options) {
  const bool can = training.folds.size() > 1;
  for (std::size_t s = 0; s < kStrengthCount; ++s) {
    const VectorXd& weights = training.weights[s];
    std::vector<Sums> parts;
    for (const Fold& fold : training.folds) parts.push_back(add_up(eq, weights, fold));
    Sums all = parts.front();
    for (std::size_t f = 1; f < parts.size(); ++f) {
      all.normal += parts[f].normal;
      all.right += parts[f].right;
    }
    const VectorXd by_row = eq.missing.rowwise().squaredNorm();
    double least = by_row.dot(weights);
    group.ridge[s] = kKeepPrior;
    group.held_out[s].resize(index(training.examples.size()));
    for (Index i = 0; i < group.held_out[s].size(); ++i) group.held_out[s][i] = by_row.segment<3>(3 * i).sum();
    if (eq.a.cols() == 0) continue;
    for (std::size_t r = 0; r < (can ? options.ridges.size() : 1); ++r) {
      VectorXd errors(index(training.examples.size()));
      double error = 0;
      for (std::size_t f = 0; f < parts.size(); ++f) {
        const Sums others = can ? Sums{all.normal - parts[f].normal, all.right - parts[f].right} : all;
        error += squared_errors(eq, weights, training.folds[f], solve(others, options.ridges[r]), errors);
      }
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

HeldOut held_out(const std::vector<Group>& groups, const Training& training, std::size_t strength) {
  VectorXd errors = VectorXd::Zero(index(training.examples.size()));
  for (const Group& group : groups) errors += group.held_out[strength];
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
std::size_t best_strength(const std::vector<Group>& groups, const Training& training, const FitOptions& options,
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

void write_solution(const Group& group, const Equations& eq, const Training& training, std::size_t strength,
                    Coordinates& out) {
  if (group.ridge[strength] == kKeepPrior) return;
  const Fold all{0, training.examples.size()};
  const MatrixXd x = eq.basis * solve(add_up(eq, training.weights[strength], all), group.ridge[strength]);
  for (std::size_t i = 0; i < group.vertices.size(); ++i) {
    std::vector<Coordinate>& vertex = out[group.vertices[i]];
    for (std::size_t j = 0; j < vertex.size(); ++j) {
      const auto part = x.col(index(i)).segment<4>(4 * index(j));
      const double delta = part[3];
      vertex[j].q +=
          glm::dvec4(glm::dvec3(part[0], part[1], part[2]) * training.diagonal_m + group.origin * delta, delta);
    }
  }
}

}  // namespace

Fit fit_coordinates(const Coordinates& prior, double diagonal_m, std::vector<TrainingPose> poses, const Deformer& truth,
                    const Deformer& reference, const FitOptions& options) {
  const Training training = prepare(prior, diagonal_m, poses, truth, reference);
  if (training.examples.empty()) return {prior, {}, 0};
  std::vector<Group> groups = group_by_joints(prior);
  Steps steps(options.progress, groups.size());
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    cross_validate(groups[g], Equations(groups[g], training, options.keep_bind_pose), training, options);
    steps.one_more();
  });
  Fit out;
  HeldOut best;
  const std::size_t strength = best_strength(groups, training, options, best);
  out.quality = best.quality;
  if (best.poses > 0)
    out.rms = std::sqrt(best.squares / static_cast<double>(best.poses) / static_cast<double>(prior.size()));
  out.coordinates = prior;
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    write_solution(groups[g], Equations(groups[g], training, options.keep_bind_pose), training, strength,
                   out.coordinates);
  });
  return out;
}

}  // namespace marrow::deform
