#include "deform/fit/training.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include <glm/geometric.hpp>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

using Eigen::VectorXd;

std::vector<Example> make_examples(double diagonal_m, const std::vector<TrainingPose>& poses, const Deformer& truth,
                                   const Deformer& reference, const Progress& progress) {
  std::vector<Example> out(poses.size());
  Steps steps(progress, poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Example& e = out[i];
    e.at = &poses[i];
    Positions now, start;
    truth(poses[i].pose, now);
    reference(poses[i].pose, start);
    for (const glm::dvec3& p : now) e.centre += p / (diagonal_m * static_cast<double>(now.size()));
    float size = 0;  // finite if all of the truth is
    for (std::size_t v = 0; v < now.size(); ++v) {
      const glm::dvec3 off = (now[v] - start[v]) / diagonal_m;
      e.reference_error += glm::dot(off, off);
      e.truth.emplace_back(now[v] / diagonal_m - e.centre);
      size += glm::dot(e.truth.back(), e.truth.back());
    }
    e.is_usable = std::isfinite(size) && std::isfinite(e.reference_error);
    steps.one_more();
  });
  return out;
}

VectorXd pose_weights(std::span<const Example> examples, const Strength& strength) {
  double mean = 0;
  for (const Example& e : examples) mean += e.reference_error / static_cast<double>(examples.size());
  VectorXd rows(3 * index(examples.size()));
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const double error = mean > 0 ? examples[i].reference_error / mean : 0.0;
    const double share = 1 / (error + strength.epsilon);
    rows.segment<3>(3 * index(i))
        .setConstant(strength.halves == 0   ? 1
                     : strength.halves == 1 ? std::sqrt(share)
                                            : share);
  }
  return rows * (1.0 / rows.sum());
}

}  // namespace

Training prepare_training(double diagonal_m, std::vector<TrainingPose>& poses, const Deformer& truth,
                          const Deformer& reference, const Progress& progress) {
  sort_by_fold(poses);
  Training out;
  out.diagonal_m = diagonal_m;
  out.examples = make_examples(diagonal_m, poses, truth, reference, progress);
  std::erase_if(out.examples, [](const Example& e) { return !e.is_usable; });
  for (const Example& e : out.examples) out.judged.push_back({e.at, e.reference_error});
  out.folds = folds_of(out.judged);
  const std::size_t learnt = out.folds.empty() ? 0 : out.folds.back().first + out.folds.back().count;
  out.motion = {learnt, out.examples.size() - learnt};
  double moved = 0;
  for (std::size_t e = learnt; e < out.examples.size(); ++e) moved += out.examples[e].reference_error;
  for (const Strength& s : kStrengths) {
    out.weights.push_back(pose_weights({out.examples.data(), learnt}, s));
    double clips = 0;
    for (std::size_t e = 0; e < learnt; ++e)
      clips += out.weights.back()[3 * index(e)] * out.examples[e].reference_error;
    out.motion_weights.push_back(moved > 0 ? clips / moved : 0);
  }
  return out;
}

std::vector<Group> group_by_joints(const Coordinates& coordinates) {
  std::map<std::vector<std::uint32_t>, Group> groups;
  for (std::uint32_t v = 0; v < coordinates.size(); ++v) {
    glm::dvec3 place(0);
    for (const Coordinate& c : coordinates[v]) place += glm::dvec3(c.q);
    Group& group = groups[joints_of(coordinates[v])];
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

Equations::Equations(const Group& group, const Training& training, std::size_t of)
    : a(3 * index(of), 4 * index(group.joints.size())), truth(a.rows(), index(group.vertices.size())) {
  const double scale = 1 / training.diagonal_m;
  for (std::size_t e = 0; e < of; ++e) {
    const Eigen::Index row = 3 * index(e);
    const Example& example = training.examples[e];
    const Pose& pose = example.at->pose;
    glm::dvec3 mean(0);
    for (const std::uint32_t j : group.joints) mean += transform(pose[j], group.origin);
    mean *= scale / static_cast<double>(group.joints.size());
    for (std::size_t j = 0; j < group.joints.size(); ++j) {
      const Matrix& m = pose[group.joints[j]];
      const glm::dvec3 at = transform(m, group.origin) * scale - mean;
      for (int r = 0; r < 3; ++r) a.row(row + r).segment<4>(4 * index(j)) << m[0][r], m[1][r], m[2][r], at[r];
    }
    for (std::size_t i = 0; i < group.vertices.size(); ++i) {
      const glm::dvec3 p = glm::dvec3(example.truth[group.vertices[i]]) + (example.centre - mean);
      truth.col(index(i)).segment<3>(row) << p.x, p.y, p.z;
    }
  }
}

Eigen::MatrixXd unknowns(const Group& group, const Coordinates& coordinates, double diagonal_m) {
  Eigen::MatrixXd out(4 * index(group.joints.size()), index(group.vertices.size()));
  for (std::size_t i = 0; i < group.vertices.size(); ++i) {
    const std::vector<Coordinate>& vertex = coordinates[group.vertices[i]];
    for (std::size_t j = 0; j < vertex.size(); ++j) {
      const glm::dvec3 place = (glm::dvec3(vertex[j].q) - group.origin * vertex[j].q.w) / diagonal_m;
      out.col(index(i)).segment<4>(4 * index(j)) << place.x, place.y, place.z, vertex[j].q.w;
    }
  }
  return out;
}

glm::dvec4 coordinate(const Group& group, const Eigen::Vector4d& u, double diagonal_m) {
  return glm::dvec4(glm::dvec3(u[0], u[1], u[2]) * diagonal_m + group.origin * u[3], u[3]);
}

}  // namespace marrow::deform
