#include "deform/fit/eigen_skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/dense.h"
#include "deform/fit/missing.h"
#include "deform/fit/solver.h"
#include "deform/motion/range_of_motion.h"
#include "deform/rotations.h"

namespace marrow::deform {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double distance(const glm::dquat& a, const glm::dquat& b) {
  const double d = glm::dot(a, b);
  return std::max(0.0, 1 - d * d);
}

const glm::dquat kUnturned(1, 0, 0, 0);

double phi(const glm::dquat& a, const glm::dquat& b, double sigma) {
  return tools::exponential(-distance(a, b) / (2 * sigma * sigma));
}

// 0 in the bind pose, almost 1 far away.
double lift(const glm::dquat& turn, double sigma) {
  return -tools::exponential_less_1(-distance(turn, kUnturned) / (2 * sigma * sigma));
}

// Of `turns` those that are farthest from each other and from none, one after the other.
std::vector<glm::dquat> spread(const std::vector<glm::dquat>& turns, std::size_t most) {
  constexpr double kLeast = 1e-4;  // a turn of one degree
  std::vector<glm::dquat> out;
  std::vector<double> nearest(turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) nearest[i] = distance(turns[i], kUnturned);
  while (out.size() < most && !turns.empty()) {
    const auto farthest = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
    if (!(nearest[farthest] > kLeast)) break;
    out.push_back(turns[farthest]);
    for (std::size_t i = 0; i < turns.size(); ++i) nearest[i] = std::min(nearest[i], distance(turns[i], out.back()));
  }
  return out;
}

// What SSD misses, in bind space; nothing where it could not be put right there.
Positions missing_of(const SkinnedMesh& mesh, const Pose& pose, const Positions& wanted) {
  Positions out;
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    const Matrix m = blended(mesh.influences[v], pose);
    out.push_back(correction(m, wanted[v] - transform(m, mesh.positions[v])).value_or(glm::dvec3(0)));
  }
  return out;
}

// What SSD misses in turns of one joint.
struct Examples {
  std::vector<glm::dquat> turns;
  std::vector<Positions> missing;  // a turn: of each vertex of the mesh, bind space
};

Examples make_examples(const SkinnedMesh& mesh, const std::vector<char>& branch, const glm::dvec3& centre,
                       const std::vector<glm::dquat>& turns, const Deformer& truth) {
  Examples out;
  Positions wanted;
  for (const glm::dquat& turn : turns) {
    const Pose pose = turned(branch, centre, glm::mat3_cast(turn));
    truth(pose, wanted);
    if (!is_finite(wanted)) continue;
    out.turns.push_back(turn);
    out.missing.push_back(missing_of(mesh, pose, wanted));
  }
  return out;
}

std::vector<std::uint32_t> support_of(const Examples& examples, std::size_t vertices, double least_m) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (std::ranges::any_of(examples.missing, [&](const Positions& p) { return glm::length(p[v]) > least_m; }))
      out.push_back(v);
  return out;
}

// The fields. Returns what each example is of them: a row an example.
MatrixXd components(const Examples& examples, std::size_t most, EigenJoint& out) {
  std::vector<Positions> missing(examples.turns.size());
  for (std::size_t a = 0; a < missing.size(); ++a)
    for (const std::uint32_t v : out.support) missing[a].push_back(examples.missing[a][v]);
  PrincipalFields found = principal_fields(missing, most);
  out.fields = std::move(found.fields);
  MatrixXd coordinates(index(missing.size()), index(out.fields.size()));
  for (std::size_t a = 0; a < missing.size(); ++a)
    for (std::size_t n = 0; n < out.fields.size(); ++n) coordinates(index(a), index(n)) = found.coordinates[a][n];
  return coordinates;
}

// Coefficients that give `wanted` in the examples, and the squared error of each example left out in turn (Rippa, "An
// algorithm for selecting a good value for the parameter c in radial basis function interpolation", 1999).
struct Interpolant {
  MatrixXd coefficients;
  double left_out = 0;
};

Interpolant interpolate(const std::vector<glm::dquat>& turns, const MatrixXd& wanted, double sigma, double ridge) {
  const std::size_t count = turns.size();
  MatrixXd system(index(count), index(count)), right = wanted;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) system(index(a), index(b)) = phi(turns[a], turns[b], sigma);
    system(index(a), index(a)) += ridge;
    right.row(index(a)) /= lift(turns[a], sigma);
  }
  const MatrixXd inverse = inverse_of_symmetric(system);
  Interpolant out{inverse * right, 0};
  for (std::size_t a = 0; a < count; ++a) {
    const double scale = lift(turns[a], sigma) / inverse(index(a), index(a));
    out.left_out += (out.coefficients.row(index(a)) * scale).squaredNorm();
  }
  return out;
}

double mean_distance(const std::vector<glm::dquat>& turns) {
  double sum = 0;
  for (const glm::dquat& a : turns) {
    double nearest = distance(a, kUnturned);
    for (const glm::dquat& b : turns)
      if (&a != &b) nearest = std::min(nearest, distance(a, b));
    sum += nearest;
  }
  return std::sqrt(sum / static_cast<double>(turns.size()));
}

// No fields where SSD is as good.
EigenJoint fit_joint(const SkinnedMesh& mesh, const Examples& examples, std::uint32_t joint,
                     const EigenSkinOptions& options) {
  EigenJoint out{joint, {}, {}, {}, {}, 1};
  if (examples.turns.empty()) return out;
  out.support = support_of(examples, mesh.positions.size(), options.least_displacement * diagonal(mesh));
  const MatrixXd wanted = components(examples, options.most_fields, out);
  const double distance = mean_distance(examples.turns);
  const auto with = [&](std::size_t w) {
    return interpolate(examples.turns, wanted, options.widths[w] * distance, options.ridge);
  };
  const Choice width = best_setting(
      VectorXd::Constant(1, wanted.squaredNorm()), options.widths.size(),
      [&](std::size_t w) { return VectorXd::Constant(1, with(w).left_out); },
      [](const VectorXd& squares) { return squares[0]; });
  if (width.setting == kKeepPrior) return {joint, {}, {}, {}, {}, 1};
  out.sigma = options.widths[width.setting] * distance;
  const MatrixXd coefficients = with(width.setting).coefficients;
  out.examples = examples.turns;
  for (Eigen::Index k = 0; k < coefficients.rows(); ++k) {
    const VectorXd row = coefficients.row(k);
    out.coefficients.emplace_back(row.data(), row.data() + row.size());
  }
  return out;
}

// What the fields are multiplied by when the joint turns.
std::vector<double> weights_of(const EigenJoint& joint, const glm::dquat& turn) {
  std::vector<double> out(joint.fields.size(), 0);
  const double from_bind = lift(turn, joint.sigma);
  for (std::size_t k = 0; k < joint.examples.size(); ++k) {
    const double scale = from_bind * phi(turn, joint.examples[k], joint.sigma);
    for (std::size_t n = 0; n < out.size(); ++n) out[n] += scale * joint.coefficients[k][n];
  }
  return out;
}

// What SSD misses in a pose, and what fields are multiplied by there, joint by joint.
struct Together {
  Positions missing;  // a vertex, bind space; empty: nothing is known
  std::vector<std::vector<double>> weights;
};

Together make_together(const SkinnedMesh& mesh, const EigenSkin& skin, const Pose& pose, const Deformer& truth) {
  Together out;
  Positions wanted;
  truth(pose, wanted);
  if (!is_finite(wanted)) return out;
  out.missing = missing_of(mesh, pose, wanted);
  const std::vector<glm::dquat> turns = local_rotations(pose, skin.parents);
  for (const EigenJoint& j : skin.joints) out.weights.push_back(weights_of(j, turns[j.joint]));
  return out;
}

// A vertex in a joint's support: which of the skin's joints, and where in its support.
struct Place {
  std::size_t joint, at;
};

// The fields at one vertex: least squares over poses, with a ridge towards what they are.
void fit_vertex(const std::vector<Together>& poses, std::size_t v, const std::vector<Place>& places, double share,
                EigenSkin& skin) {
  std::vector<glm::dvec3*> fields;
  for (const Place& p : places)
    for (Positions& field : skin.joints[p.joint].fields) fields.push_back(&field[p.at]);
  MatrixXd weights(index(poses.size()), index(fields.size())), lacking(index(poses.size()), 3);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    glm::dvec3 left = poses[i].missing[v];
    Eigen::Index column = 0;
    for (const Place& p : places)
      for (const double weight : poses[i].weights[p.joint]) {
        left -= *fields[static_cast<std::size_t>(column)] * weight;
        weights(index(i), column++) = weight;
      }
    lacking.row(index(i)) << left.x, left.y, left.z;
  }
  MatrixXd normal = weights.transpose() * weights;
  const double ridge = share * normal.trace() / static_cast<double>(fields.size());
  if (!(ridge > 0)) return;
  normal.diagonal().array() += ridge;
  const MatrixXd more = solve_symmetric(normal, MatrixXd(weights.transpose() * lacking));
  for (std::size_t n = 0; n < fields.size(); ++n)
    *fields[n] += glm::dvec3(more(index(n), 0), more(index(n), 1), more(index(n), 2));
}

void fit_together(const SkinnedMesh& mesh, const std::vector<TrainingPose>& poses, const Deformer& truth, double share,
                  EigenSkin& skin) {
  if (!std::isfinite(share)) return;
  std::vector<Together> together(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    if (poses[i].learnt) together[i] = make_together(mesh, skin, poses[i].pose, truth);
  });
  std::erase_if(together, [](const Together& t) { return t.missing.empty(); });
  std::vector<std::vector<Place>> places(mesh.positions.size());
  for (std::size_t j = 0; j < skin.joints.size(); ++j)
    for (std::size_t i = 0; i < skin.joints[j].support.size(); ++i) places[skin.joints[j].support[i]].push_back({j, i});
  tools::for_each_in_parallel(places.size(), [&](std::size_t v) {
    if (!places[v].empty()) fit_vertex(together, v, places[v], share, skin);
  });
}

}  // namespace

Deformer eigen_skin(const SkinnedMesh& mesh, const EigenSkin& skin) {
  return [&mesh, &skin](const Pose& pose, Positions& out) {
    const std::vector<glm::dquat> turns = local_rotations(pose, skin.parents);
    Positions displaced = mesh.positions;
    for (const EigenJoint& j : skin.joints) {
      const std::vector<double> weights = weights_of(j, turns[j.joint]);
      for (std::size_t n = 0; n < weights.size(); ++n)
        for (std::size_t i = 0; i < j.support.size(); ++i) displaced[j.support[i]] += j.fields[n][i] * weights[n];
    }
    out.resize(displaced.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = transform(blended(mesh.influences[v], pose), displaced[v]);
  };
}

EigenSkin fit_eigen_skin(const SkinnedMesh& mesh, const std::vector<int>& parents,
                         const std::vector<glm::dvec3>& centres, const std::vector<TrainingPose>& poses,
                         const Deformer& truth, const EigenSkinOptions& options) {
  std::vector<std::vector<glm::dquat>> turns(parents.size());
  for (const TrainingPose& p : poses) {
    if (!p.learnt) continue;
    const std::vector<glm::dquat> local = local_rotations(p.pose, parents);
    for (std::size_t j = 0; j < turns.size(); ++j) turns[j].push_back(local[j]);
  }
  std::vector<EigenJoint> joints(parents.size());
  tools::for_each_in_parallel(parents.size(), [&](std::size_t j) {
    const auto joint = static_cast<std::uint32_t>(j);
    const Examples examples =
        make_examples(mesh, turned_along(joint, parents), centres[j], spread(turns[j], options.most_examples), truth);
    joints[j] = fit_joint(mesh, examples, joint, options);
  });
  EigenSkin out{parents, {}};
  for (EigenJoint& j : joints)
    if (!j.fields.empty()) out.joints.push_back(std::move(j));
  fit_together(mesh, poses, truth, options.together, out);
  return out;
}

double displacements_per_vertex(const SkinnedMesh& mesh, const EigenSkin& skin) {
  std::size_t sum = 0;
  for (const EigenJoint& j : skin.joints) sum += j.fields.size() * j.support.size();
  return static_cast<double>(sum) / static_cast<double>(mesh.positions.size());
}

}  // namespace marrow::deform
