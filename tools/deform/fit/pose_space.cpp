#include "deform/fit/pose_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "common/distinct.h"
#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/dense.h"
#include "deform/fit/missing.h"
#include "deform/fit/solver.h"
#include "deform/rotations.h"

namespace marrow::deform {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rotations = std::vector<glm::dquat>;

// D of each joint.
using Distances = std::vector<double>;

Distances distances(const Rotations& a, const Rotations& b) {
  Distances out;
  for (std::size_t j = 0; j < a.size(); ++j) {
    const double d = glm::dot(a[j], b[j]);
    out.push_back(std::max(0.0, 1 - d * d));
  }
  return out;
}

double weighted(const std::vector<Influence>& influences, const Distances& d) {
  double sum = 0;
  for (const Influence& i : influences) sum += i.weight * d[i.joint];
  return sum;
}

// Vertices that follow the same joints by the same weights see poses alike: one answer is all of theirs.
struct Groups {
  std::vector<std::uint32_t> of_vertex;
  std::vector<const std::vector<Influence>*> influences;  // a group

  explicit Groups(const SkinnedMesh& mesh) {
    std::map<std::vector<std::pair<std::uint32_t, double>>, std::uint32_t> found;
    for (const std::vector<Influence>& of : mesh.influences) {
      std::vector<std::pair<std::uint32_t, double>> key;
      for (const Influence& i : of) key.emplace_back(i.joint, i.weight);
      const auto [at, is_new] = found.try_emplace(std::move(key), static_cast<std::uint32_t>(influences.size()));
      if (is_new) influences.push_back(&of);
      of_vertex.push_back(at->second);
    }
  }
};

// How far a pose is from the examples and from the bind pose.
struct FromExamples {
  Distances bind;
  std::vector<Distances> to;  // an example

  FromExamples(const Rotations& pose, const std::vector<const Rotations*>& examples)
      : bind(distances(pose, Rotations(pose.size(), glm::dquat(1, 0, 0, 0)))) {
    for (const Rotations* const e : examples) to.push_back(distances(pose, *e));
  }
  double phi(const std::vector<Influence>& influences, std::size_t k, double sigma) const {
    return tools::exponential(-weighted(influences, to[k]) / (2 * sigma * sigma));
  }
  // How far the pose is from the bind pose: 0 there, almost 1 far away.
  double lift(const std::vector<Influence>& influences, double sigma) const {
    return -tools::exponential_less_1(-weighted(influences, bind) / (2 * sigma * sigma));
  }
};

// What groups see of a pose.
struct Seen {
  Seen(const Groups& groups, const FromExamples& from, double sigma, const Pose& pose) : examples(from.to.size()) {
    for (const std::vector<Influence>* const influences : groups.influences) {
      for (std::size_t k = 0; k < examples; ++k) phi.push_back(from.phi(*influences, k, sigma));
      lift.push_back(from.lift(*influences, sigma));
      blend.push_back(blended(*influences, pose));
    }
  }
  std::size_t examples;
  std::vector<double> phi;  // of each group its examples
  std::vector<double> lift;
  std::vector<Matrix> blend;
};

// A pose of the training with what SSD misses there.
struct PoseExample {
  Rotations rotations;
  std::vector<glm::dvec3> missing;  // a vertex: truth less SSD, metres, where the pose is
  double reference_error = 0;       // squares, summed
};

PoseExample make_example(const SkinnedMesh& mesh, const std::vector<int>& parents, const Pose& pose,
                         const Deformer& truth) {
  PoseExample e;
  e.rotations = local_rotations(pose, parents);
  Positions wanted;
  truth(pose, wanted);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    e.missing.push_back(wanted[v] - transform(blended(mesh.influences[v], pose), mesh.positions[v]));
    e.reference_error += glm::dot(e.missing[v], e.missing[v]);
  }
  return e;
}

struct Examples {
  const SkinnedMesh& mesh;
  Groups groups;
  std::vector<TrainingPose> poses;
  std::vector<PoseExample> examples;  // a pose
  double diagonal_m;
};

// What is interpolated: some of the examples, with deltas a vertex.
struct Interpolant {
  std::vector<std::size_t> chosen;
  double sigma = 1;
  std::vector<Positions> deltas;  // a chosen example
};

std::vector<const Rotations*> rotations_of_chosen(const Examples& t, const std::vector<std::size_t>& chosen) {
  std::vector<const Rotations*> out;
  for (const std::size_t c : chosen) out.push_back(&t.examples[c].rotations);
  return out;
}

// The deltas of one vertex: lift Σ_k φ_k d_k is the correction in each example that can say what it is, but for the
// ridge.
void solve_vertex(const Examples& t, std::size_t v, const std::vector<FromExamples>& from,
                  const PoseSpaceOptions& options, Interpolant& out) {
  constexpr double kLeastLift = 1e-6;  // nothing that moves the vertex differs from the bind pose
  const std::vector<Influence>& influences = t.mesh.influences[v];
  std::vector<std::size_t> used;
  std::vector<glm::dvec3> corrections;
  for (std::size_t k = 0; k < out.chosen.size(); ++k) {
    const double lift = from[k].lift(influences, out.sigma);
    if (lift < kLeastLift) continue;
    const std::size_t pose = out.chosen[k];
    const auto c = correction(blended(influences, t.poses[pose].pose), t.examples[pose].missing[v]);
    if (!c) continue;
    used.push_back(k);
    corrections.push_back(*c / lift);
  }
  MatrixXd system(index(used.size()), index(used.size())), right(index(used.size()), 3);
  for (std::size_t a = 0; a < used.size(); ++a) {
    for (std::size_t b = 0; b < used.size(); ++b)
      system(index(a), index(b)) = from[used[a]].phi(influences, used[b], out.sigma);
    right.row(index(a)) << corrections[a].x, corrections[a].y, corrections[a].z;
  }
  if (used.empty() || right.isZero(0)) return;
  constexpr double kMostRidge = 1e12;
  const double most = options.most_delta * t.diagonal_m;
  double ridge = options.ridge;
  MatrixXd x;
  do {
    MatrixXd ridged = system;
    ridged.diagonal().array() += ridge;
    x = solve_symmetric(ridged, right);
    ridge *= 10;
  } while (!(x.rowwise().norm().maxCoeff() <= most) && ridge < kMostRidge);
  if (!(x.rowwise().norm().maxCoeff() <= most)) return;
  for (std::size_t a = 0; a < used.size(); ++a)
    out.deltas[used[a]][v] = {x(index(a), 0), x(index(a), 1), x(index(a), 2)};
}

Interpolant interpolate(const Examples& t, const std::vector<std::size_t>& chosen, double sigma,
                        const PoseSpaceOptions& options) {
  Interpolant out{chosen, sigma, {}};
  out.deltas.assign(chosen.size(), Positions(t.mesh.positions.size(), glm::dvec3(0)));
  const auto others = rotations_of_chosen(t, chosen);
  std::vector<FromExamples> from;
  for (const std::size_t c : chosen) from.emplace_back(t.examples[c].rotations, others);
  constexpr std::size_t kVertices = 256;
  tools::for_each_in_parallel((t.mesh.positions.size() + kVertices - 1) / kVertices, [&](std::size_t part) {
    const std::size_t end = std::min(t.mesh.positions.size(), (part + 1) * kVertices);
    for (std::size_t v = part * kVertices; v < end; ++v) solve_vertex(t, v, from, options, out);
  });
  return out;
}

// Squared errors of poses, summed over vertices.
std::vector<double> errors_of(const Examples& t, const Interpolant& with, const std::vector<std::size_t>& poses) {
  std::vector<double> out(poses.size(), 0);
  const auto examples = rotations_of_chosen(t, with.chosen);
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    const Seen seen(t.groups, {t.examples[poses[i]].rotations, examples}, with.sigma, t.poses[poses[i]].pose);
    for (std::size_t v = 0; v < t.mesh.positions.size(); ++v) {
      const std::uint32_t group = t.groups.of_vertex[v];
      glm::dvec3 delta(0);
      for (std::size_t k = 0; k < with.chosen.size(); ++k)
        if (with.deltas[k][v] != glm::dvec3(0)) delta += with.deltas[k][v] * seen.phi[group * seen.examples + k];
      delta *= seen.lift[group];
      const glm::dvec3 off = t.examples[poses[i]].missing[v] - linear_of(seen.blend[group]) * delta;
      out[i] += glm::dot(off, off);
    }
  });
  return out;
}

// The root mean square over vertices that move of how far it is from an example to the nearest other or the bind pose.
double mean_distance(const Examples& t, const std::vector<std::size_t>& chosen) {
  double sum = 0;
  std::size_t count = 0;
  const auto others = rotations_of_chosen(t, chosen);
  for (std::size_t a = 0; a < chosen.size(); ++a) {
    const FromExamples from(*others[a], others);
    for (const std::vector<Influence>& influences : t.mesh.influences) {
      double nearest = weighted(influences, from.bind);
      for (std::size_t b = 0; b < chosen.size(); ++b)
        if (b != a) nearest = std::min(nearest, weighted(influences, from.to[b]));
      if (nearest < 1e-6) continue;
      sum += nearest;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 1.0;
}

// Of `poses`, the worst first.
std::vector<std::size_t> choose_examples(const Examples& t, const std::vector<std::size_t>& poses,
                                         const PoseSpaceOptions& options) {
  std::vector<std::size_t> chosen;
  while (chosen.size() < std::min(options.most_examples, poses.size())) {
    const Interpolant now = interpolate(t, chosen, options.widths[0] * mean_distance(t, chosen), options);
    const std::vector<double> errors = errors_of(t, now, poses);
    std::size_t worst = poses.size();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (std::find(chosen.begin(), chosen.end(), poses[i]) != chosen.end() || !(errors[i] > 0)) continue;
      if (worst == poses.size() || errors[i] > errors[worst]) worst = i;
    }
    if (worst == poses.size()) break;
    chosen.push_back(poses[worst]);
  }
  return chosen;
}

// One part, the whole mesh, whose examples all vertices share. Settings: widths. Without a prior: whether what is
// learnt beats SSD is seen in the end.
class PoseSpaceBasis final : public Basis {
 public:
  PoseSpaceBasis(const Examples& examples, const PoseSpaceOptions& options, PoseSpaceFit& out)
      : t_(examples), options_(options), out_(out) {}

  std::size_t parts() const override { return 1; }

  Part choose(std::size_t) override {
    std::vector<std::uint32_t> folds;
    for (const TrainingPose& p : t_.poses) folds.push_back(p.fold);
    tools::make_distinct(folds);
    const bool can = folds.size() > 1;
    MatrixXd errors = MatrixXd::Zero(index(t_.poses.size()), index(can ? options_.widths.size() : 1));
    Steps steps(options_.progress, folds.size());
    for (const std::uint32_t fold : folds) {
      std::vector<std::size_t> inside, others;
      for (std::size_t p = 0; p < t_.poses.size(); ++p) (t_.poses[p].fold == fold ? inside : others).push_back(p);
      const std::vector<std::size_t> chosen = choose_examples(t_, can ? others : inside, options_);
      const double distance = mean_distance(t_, chosen);
      for (Eigen::Index w = 0; w < errors.cols(); ++w) {
        const double sigma = options_.widths[static_cast<std::size_t>(w)] * distance;
        const std::vector<double> of_fold = errors_of(t_, interpolate(t_, chosen, sigma, options_), inside);
        for (std::size_t i = 0; i < inside.size(); ++i) errors(index(inside[i]), w) = of_fold[i];
      }
      steps.one_more();
    }
    const VectorXd none = VectorXd::Constant(errors.rows(), std::numeric_limits<double>::infinity());
    return {none,
            {best_setting(
                none, static_cast<std::size_t>(errors.cols()), [&](std::size_t w) { return errors.col(index(w)); },
                [](const VectorXd& of) { return of.sum(); })}};
  }

  void solve(std::size_t, std::size_t, std::size_t width) override {
    std::vector<std::size_t> all(t_.poses.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    out_.chosen = choose_examples(t_, all, options_);
    out_.space.sigma = options_.widths[width] * mean_distance(t_, out_.chosen);
    Interpolant with = interpolate(t_, out_.chosen, out_.space.sigma, options_);
    for (std::size_t k = 0; k < out_.chosen.size(); ++k)
      out_.space.examples.push_back({t_.examples[out_.chosen[k]].rotations, std::move(with.deltas[k])});
  }

 private:
  const Examples& t_;
  const PoseSpaceOptions& options_;
  PoseSpaceFit& out_;
};

}  // namespace

Deformer pose_space(const SkinnedMesh& mesh, const PoseSpace& space) {
  return [&mesh, &space, groups = std::make_shared<const Groups>(mesh)](const Pose& pose, Positions& out) {
    std::vector<const Rotations*> examples;
    for (const PoseSpaceExample& e : space.examples) examples.push_back(&e.rotations);
    const Seen seen(*groups, {local_rotations(pose, space.parents), examples}, space.sigma, pose);
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
      const std::uint32_t group = groups->of_vertex[v];
      glm::dvec3 delta(0);
      for (std::size_t k = 0; k < examples.size(); ++k)
        delta += space.examples[k].deltas[v] * seen.phi[group * seen.examples + k];
      out[v] = transform(seen.blend[group], mesh.positions[v] + delta * seen.lift[group]);
    }
  };
}

PoseSpaceFit fit_pose_space(const SkinnedMesh& mesh, const std::vector<int>& parents, std::vector<TrainingPose> poses,
                            const Deformer& truth, const PoseSpaceOptions& options) {
  Examples t{mesh, Groups(mesh), std::move(poses), {}, diagonal(mesh)};
  t.examples.resize(t.poses.size());
  tools::for_each_in_parallel(
      t.poses.size(), [&](std::size_t p) { t.examples[p] = make_example(mesh, parents, t.poses[p].pose, truth); });
  std::vector<JudgedPose> judged;
  for (std::size_t p = 0; p < t.poses.size(); ++p) judged.push_back({&t.poses[p], t.examples[p].reference_error});
  PoseSpaceFit out;
  out.space.parents = parents;
  PoseSpaceBasis basis(t, options, out);
  const Chosen chosen = choose_settings(basis, judged, 0, {});
  if (!(chosen.quality.share < 1)) return out;
  out.quality = chosen.quality;
  solve(basis, chosen);
  return out;
}

}  // namespace marrow::deform
