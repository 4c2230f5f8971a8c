#include "deform/fit/multi_weight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/dense.h"
#include "deform/rotation_of_matrix.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kKeepSsd = std::numeric_limits<std::size_t>::max();

struct RootFrame {
  glm::dmat3 rotation;
  glm::dvec3 origin;

  RootFrame(const Pose& pose, std::uint32_t root)
      : rotation(rotation_of(linear_of(pose[root]))), origin(pose[root][3]) {}
  Matrix inside(const Matrix& m) const {
    const glm::dmat3 back = glm::transpose(rotation);
    return {back * m[0], back * m[1], back * m[2], back * (m[3] - origin)};
  }
};

// Rows of one fold's poses.
struct Fold {
  std::size_t first, count;
};

struct Training {
  std::vector<TrainingPose> poses;              // by ascending fold
  std::vector<Fold> folds;                      // none is empty
  std::vector<Pose> inside;                     // in the root's frame, translations in diagonals
  std::vector<std::vector<glm::vec3>> missing;  // a pose, vertex: truth less SSD, in that frame and in diagonals
  std::vector<double> reference_error;          // a pose: squares, summed
  double diagonal_m = 1;
};

Training prepare(const SkinnedMesh& mesh, std::uint32_t root, std::vector<TrainingPose> poses, const Deformer& truth) {
  Training out;
  std::stable_sort(poses.begin(), poses.end(),
                   [](const TrainingPose& a, const TrainingPose& b) { return a.fold < b.fold; });
  out.poses = std::move(poses);
  out.diagonal_m = diagonal(mesh) > 0 ? diagonal(mesh) : 1;
  for (std::size_t i = 0; i < out.poses.size(); ++i) {
    if (i == 0 || out.poses[i].fold != out.poses[i - 1].fold) out.folds.push_back({i, 0});
    ++out.folds.back().count;
  }
  out.inside.resize(out.poses.size());
  out.missing.resize(out.poses.size());
  out.reference_error.assign(out.poses.size(), 0);
  const Deformer start = ssd(mesh);
  tools::for_each_in_parallel(out.poses.size(), [&](std::size_t i) {
    const Pose& pose = out.poses[i].pose;
    const RootFrame frame(pose, root);
    for (const Matrix& m : pose) {
      out.inside[i].push_back(frame.inside(m));
      out.inside[i].back()[3] /= out.diagonal_m;
    }
    Positions wanted, got;
    truth(pose, wanted);
    start(pose, got);
    for (std::size_t v = 0; v < got.size(); ++v) {
      const glm::dvec3 off = glm::transpose(frame.rotation) * (wanted[v] - got[v]) / out.diagonal_m;
      out.reference_error[i] += glm::dot(off, off);
      out.missing[i].emplace_back(off);
    }
  });
  return out;
}

// Vertices that follow the same joints.
struct Group {
  std::vector<std::uint32_t> joints, vertices;
  std::size_t ridge = kKeepSsd;  // which
  VectorXd held_out;             // squared errors, a pose
};

std::vector<Group> group_by_joints(const SkinnedMesh& mesh) {
  std::map<std::vector<std::uint32_t>, std::vector<std::uint32_t>> groups;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::vector<std::uint32_t> joints;
    for (const Influence& i : mesh.influences[v]) joints.push_back(i.joint);
    groups[joints].push_back(v);
  }
  std::vector<Group> out;
  for (auto& [joints, vertices] : groups) out.push_back({joints, std::move(vertices), kKeepSsd, {}});
  return out;
}

// One row of a group's equations: of a vertex, `matrix` · diag(v, 1, v, 1, …) · unknowns is what is missing.
struct Row {
  MatrixXd matrix;               // a pose; unknown 4 j + c of joint j
  std::vector<MatrixXd> normal;  // a fold, per pose of all
  MatrixXd all;

  Row(const Group& group, const Training& training, int r)
      : matrix(index(training.poses.size()), 4 * index(group.joints.size())) {
    for (std::size_t p = 0; p < training.poses.size(); ++p)
      for (std::size_t j = 0; j < group.joints.size(); ++j)
        for (int c = 0; c < 4; ++c) matrix(index(p), 4 * index(j) + c) = training.inside[p][group.joints[j]][c][r];
    all = MatrixXd::Zero(matrix.cols(), matrix.cols());
    for (const Fold& f : training.folds) {
      const auto part = matrix.middleRows(index(f.first), index(f.count));
      normal.emplace_back(part.transpose() * part / static_cast<double>(training.poses.size()));
      all += normal.back();
    }
  }
};

// A vertex's side of them.
struct VertexRow {
  VectorXd scale, missing;
  std::vector<VectorXd> right;  // a fold
  VectorXd all;

  VertexRow(const Row& row, const Training& training, const glm::dvec3& v, std::uint32_t vertex, int r)
      : scale(row.matrix.cols()), missing(row.matrix.rows()), all(VectorXd::Zero(row.matrix.cols())) {
    for (Index i = 0; i < scale.size(); ++i)
      scale[i] = i % 4 < 3 ? v[static_cast<int>(i % 4)] / training.diagonal_m : 1;
    for (std::size_t p = 0; p < training.poses.size(); ++p)
      missing[index(p)] = static_cast<double>(training.missing[p][vertex][r]);
    for (const Fold& f : training.folds) {
      const VectorXd sum = row.matrix.middleRows(index(f.first), index(f.count)).transpose() *
                           missing.segment(index(f.first), index(f.count));
      right.emplace_back(scale.cwiseProduct(sum) / static_cast<double>(training.poses.size()));
      all += right.back();
    }
  }
  VectorXd solve(const MatrixXd& normal, const VectorXd& sum, double ridge) const {
    MatrixXd m = scale.asDiagonal() * normal * scale.asDiagonal();
    m.diagonal().array() += ridge;
    return solve_symmetric(m, sum);
  }
};

// Adds the squared errors of each ridge and pose to `errors`, a ridge a column.
void add_held_out(const Row& row, const VertexRow& vertex, const Training& training, const std::vector<double>& ridges,
                  MatrixXd& errors) {
  const bool can = training.folds.size() > 1;
  for (std::size_t f = 0; f < training.folds.size(); ++f) {
    const Fold& fold = training.folds[f];
    const MatrixXd others = can ? MatrixXd(row.all - row.normal[f]) : row.all;
    const VectorXd right = can ? VectorXd(vertex.all - vertex.right[f]) : vertex.all;
    const auto part = row.matrix.middleRows(index(fold.first), index(fold.count));
    for (Index i = 0; i < errors.cols(); ++i) {
      const VectorXd x = vertex.scale.cwiseProduct(vertex.solve(others, right, ridges[static_cast<std::size_t>(i)]));
      const VectorXd off = part * x - vertex.missing.segment(index(fold.first), index(fold.count));
      errors.col(i).segment(index(fold.first), index(fold.count)) += off.cwiseAbs2();
    }
  }
}

void cross_validate(const SkinnedMesh& mesh, const Training& training, const std::vector<double>& ridges,
                    Group& group) {
  const std::size_t tried = training.folds.size() > 1 ? ridges.size() : 1;
  MatrixXd errors = MatrixXd::Zero(index(training.poses.size()), index(tried));
  group.held_out = VectorXd::Zero(index(training.poses.size()));
  for (int r = 0; r < 3; ++r) {
    const Row row(group, training, r);
    for (const std::uint32_t v : group.vertices) {
      const VertexRow vertex(row, training, mesh.positions[v], v, r);
      group.held_out += vertex.missing.cwiseAbs2();
      add_held_out(row, vertex, training, ridges, errors);
    }
  }
  for (std::size_t i = 0; i < tried; ++i) {
    if (!(errors.col(index(i)).sum() < group.held_out.sum())) continue;
    group.ridge = i;
    group.held_out = errors.col(index(i));
  }
}

void write_solution(const SkinnedMesh& mesh, const Training& training, const std::vector<double>& ridges,
                    const Group& group, MultiWeights& out) {
  if (group.ridge == kKeepSsd) return;
  for (int r = 0; r < 3; ++r) {
    const Row row(group, training, r);
    for (const std::uint32_t v : group.vertices) {
      const VertexRow vertex(row, training, mesh.positions[v], v, r);
      const VectorXd x = vertex.solve(row.all, vertex.all, ridges[group.ridge]);
      for (std::size_t j = 0; j < out[v].size(); ++j)
        for (int c = 0; c < 4; ++c) out[v][j].rows[static_cast<std::size_t>(r)][c] += x[4 * index(j) + c];
    }
  }
}

FitQuality quality_of(const std::vector<Group>& groups, const Training& training) {
  double ours = 0, reference = 0;
  std::size_t worse = 0, shipped = 0;
  for (std::size_t p = 0; p < training.poses.size(); ++p) {
    if (!training.poses[p].shipped) continue;
    double error = 0;
    for (const Group& group : groups) error += group.held_out[index(p)];
    ++shipped;
    ours += error;
    reference += training.reference_error[p];
    worse += error > training.reference_error[p];
  }
  if (!(reference > 0)) return {};
  return {std::sqrt(ours / reference), static_cast<double>(worse) / static_cast<double>(shipped)};
}

}  // namespace

Deformer multi_weight(const SkinnedMesh& mesh, const MultiWeights& weights, std::uint32_t root) {
  return [&mesh, &weights, root](const Pose& pose, Positions& out) {
    const RootFrame frame(pose, root);
    Pose inside;
    for (const Matrix& m : pose) inside.push_back(frame.inside(m));
    out.assign(weights.size(), glm::dvec3(0));
    for (std::size_t v = 0; v < out.size(); ++v) {
      const glm::dvec4 bind(mesh.positions[v], 1);
      for (const MultiWeight& w : weights[v])
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 4; ++c)
            out[v][r] += w.rows[static_cast<std::size_t>(r)][c] * inside[w.joint][c][r] * bind[c];
      out[v] = frame.rotation * out[v] + frame.origin;
    }
  };
}

MultiWeights single_weights(const SkinnedMesh& mesh) {
  MultiWeights out(mesh.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v)
    for (const Influence& i : mesh.influences[v]) {
      const glm::dvec4 row(i.weight);
      out[v].push_back({i.joint, {row, row, row}});
    }
  return out;
}

MultiWeightFit fit_multi_weights(const SkinnedMesh& mesh, std::uint32_t root, std::vector<TrainingPose> poses,
                                 const Deformer& truth, const MultiWeightOptions& options) {
  const Training training = prepare(mesh, root, std::move(poses), truth);
  std::vector<Group> groups = group_by_joints(mesh);
  Steps steps(options.progress, groups.size());
  tools::for_each_in_parallel(groups.size(), [&](std::size_t g) {
    cross_validate(mesh, training, options.ridges, groups[g]);
    steps.one_more();
  });
  MultiWeightFit out{single_weights(mesh), quality_of(groups, training)};
  tools::for_each_in_parallel(
      groups.size(), [&](std::size_t g) { write_solution(mesh, training, options.ridges, groups[g], out.weights); });
  return out;
}

}  // namespace marrow::deform
