#include "deform/fit/multi_weight.h"

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/dense.h"
#include "deform/fit/training.h"
#include "deform/rotations.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

// Training poses as they are from the root joint.
struct RootedTraining {
  std::vector<TrainingPose> poses;  // by ascending fold
  std::vector<JudgedPose> judged;   // the same
  std::vector<Fold> folds;
  std::vector<Pose> inside;                     // in the root's frame, translations in diagonals
  std::vector<std::vector<glm::vec3>> missing;  // a pose, vertex: truth less SSD, in that frame and in diagonals
  double diagonal_m = 1;
};

RootedTraining prepare(const SkinnedMesh& mesh, std::uint32_t root, std::vector<TrainingPose> poses,
                       const Deformer& truth) {
  RootedTraining out;
  sort_by_fold(poses);
  out.poses = std::move(poses);
  out.diagonal_m = diagonal(mesh) > 0 ? diagonal(mesh) : 1;
  for (const TrainingPose& p : out.poses) out.judged.push_back({&p, 0});
  out.folds = folds_of(out.judged);
  out.inside.resize(out.poses.size());
  out.missing.resize(out.poses.size());
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
      out.judged[i].reference_error += glm::dot(off, off);
      out.missing[i].emplace_back(off);
    }
  });
  return out;
}

// One row of a group's equations: of a vertex, `matrix` · diag(v, 1, v, 1, …) · unknowns is what is missing.
struct Row {
  MatrixXd matrix;               // a pose; unknown 4 j + c of joint j
  std::vector<MatrixXd> normal;  // a fold, per pose of all
  MatrixXd all;

  Row(const Group& group, const RootedTraining& training, int r)
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

  VertexRow(const Row& row, const RootedTraining& training, const glm::dvec3& v, std::uint32_t vertex, int r)
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
void add_held_out(const Row& row, const VertexRow& vertex, const RootedTraining& training,
                  const std::vector<double>& ridges, MatrixXd& errors) {
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

// Parts: vertices that follow the same joints. Settings: ridges.
class MultiWeightBasis final : public Basis {
 public:
  MultiWeightBasis(const SkinnedMesh& mesh, const RootedTraining& training, const std::vector<double>& ridges,
                   MultiWeights& out)
      : mesh_(mesh), training_(training), ridges_(ridges), groups_(group_by_joints(lift(mesh))), out_(out) {}

  std::size_t parts() const override { return groups_.size(); }

  Part choose(std::size_t part) override {
    const Index poses = index(training_.poses.size());
    MatrixXd errors = MatrixXd::Zero(poses, index(training_.folds.size() > 1 ? ridges_.size() : 1));
    Part out{VectorXd::Zero(poses), {}};
    for_each_row(part, [&](const Row& row, const VertexRow& vertex, std::uint32_t, int) {
      out.prior += vertex.missing.cwiseAbs2();
      add_held_out(row, vertex, training_, ridges_, errors);
    });
    out.chosen.push_back(best_setting(
        out.prior, static_cast<std::size_t>(errors.cols()), [&](std::size_t r) { return errors.col(index(r)); },
        [](const VectorXd& of) { return of.sum(); }));
    return out;
  }

  void solve(std::size_t part, std::size_t, std::size_t ridge) override {
    for_each_row(part, [&](const Row& row, const VertexRow& vertex, std::uint32_t v, int r) {
      const VectorXd x = vertex.solve(row.all, vertex.all, ridges_[ridge]);
      for (std::size_t j = 0; j < out_[v].size(); ++j)
        for (int c = 0; c < 4; ++c) out_[v][j].rows[static_cast<std::size_t>(r)][c] += x[4 * index(j) + c];
    });
  }

 private:
  // Calls each(row, its side of a vertex, the vertex, which row).
  template <class Each>
  void for_each_row(std::size_t part, const Each& each) const {
    for (int r = 0; r < 3; ++r) {
      const Row row(groups_[part], training_, r);
      for (const std::uint32_t v : groups_[part].vertices)
        each(row, VertexRow(row, training_, mesh_.positions[v], v, r), v, r);
    }
  }

  const SkinnedMesh& mesh_;
  const RootedTraining& training_;
  const std::vector<double>& ridges_;
  std::vector<Group> groups_;
  MultiWeights& out_;
};

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
  const RootedTraining training = prepare(mesh, root, std::move(poses), truth);
  MultiWeightFit out{single_weights(mesh), {}};
  MultiWeightBasis basis(mesh, training, options.ridges, out.weights);
  const Chosen chosen = choose_settings(basis, training.judged, 0, options.progress);
  out.quality = chosen.quality;
  solve(basis, chosen);
  return out;
}

}  // namespace marrow::deform
