#include "deform/elastic/elastic.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/elastic/embedding.h"
#include "deform/look/mesh_parts.h"
#include "deform/rotation_blend.h"
#include "deform/rotation_of_matrix.h"

namespace marrow::deform {
namespace {

constexpr double kOneJoint = 0.97;    // of a weight
constexpr double kMostPulled = 0.02;  // of the diagonal
constexpr double kStretches = 1e-6;   // joints that are stretched less are not
constexpr double kStiff = 0.6;        // of how much the body stretches a part: what joints stretch a stiff one at most
constexpr double kSeen = 0.002;       // of lengths: a part that the body stretches less in the mean is none to see

bool is_finite(const Matrix& m) {
  double sum = 0;
  for (int c = 0; c < 4; ++c) sum += glm::dot(m[c], m[c]);
  return std::isfinite(sum);
}

// What the whole does: the motion of its heaviest joint. Bodies are reckoned with as if that stood still, so that they
// are as exact wherever they stand.
struct Motion {
  glm::dmat3 turn{1};
  double scale = 1;  // below 0: a mirror
  glm::dvec3 from{0}, to{0};

  Motion(const Matrix& m, const glm::dvec3& centre)
      : turn(nearest_rotation(linear_of(m))), from(centre), to(transform(m, centre)) {
    const double volume = glm::determinant(linear_of(m));
    scale = tools::cube_root(std::abs(volume));
    if (volume < 0) scale = -scale;
  }

  // m in places of a lattice, without this motion.
  Matrix without(const Matrix& m, double side) const {
    const glm::dmat3 back = glm::transpose(turn);
    const glm::dmat3 linear = back * linear_of(m) * (1 / scale);
    return {linear[0], linear[1], linear[2], back * (transform(m, from) - to) * (1 / (scale * side))};
  }
  glm::dvec3 with(const glm::dvec3& place, double side) const { return turn * (place * (scale * side)) + to; }
};

}  // namespace

struct Elastic::Parts {
  Parts(const SkinnedMesh& m, const ElasticOptions& options, std::size_t cells)
      : mesh(m), body(make_body(m, options, cells)), embedding(body, m), by_rig(dual_quaternions(m)) {
    std::vector<double> carries(m.joint_count, 0);
    for (const std::vector<Influence>& vertex : m.influences)
      for (const Influence& i : vertex) carries[i.joint] += i.weight;
    for (std::uint32_t j = 0; j < m.joint_count; ++j) {
      if (carries[j] > carries[heaviest]) heaviest = j;
      if (carries[j] > 0) followed.push_back(j);
    }
    for (std::vector<Influence>& node : body.weights)
      if (node.empty()) node = {{heaviest, 1.0}};
  }

  bool can_be_posed(const Pose& pose) const {
    if (body.cells.empty() || followed.empty() || !has_rotation(linear_of(pose[heaviest]))) return false;
    return std::ranges::all_of(followed, [&](std::uint32_t j) { return is_finite(pose[j]); });
  }

  // pose: in places of the lattice.
  Carried carry(const Pose& pose, const std::vector<glm::dquat>& rotations) const {
    Carried out;
    std::vector<glm::dmat3> stretches;
    bool any = false;
    for (std::size_t j = 0; j < pose.size(); ++j) {
      const glm::dmat3 s = glm::transpose(glm::mat3_cast(rotations[j])) * linear_of(pose[j]);
      stretches.push_back(s);
      if (!std::ranges::binary_search(followed, static_cast<std::uint32_t>(j))) continue;
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) any = any || std::abs(s[c][r] - (c == r ? 1.0 : 0.0)) > kStretches;
    }
    for (std::size_t n = 0; n < body.weights.size(); ++n) {
      const std::vector<Influence>& weights = body.weights[n];
      out.places.push_back(by_dual_quaternion(weights, rotations, pose, glm::dvec3(body.lattice.nodes[n])));
      out.turns.push_back(
          glm::normalize(blend_rotations(weights, rotations, [](const Influence&, const glm::dquat&) {})));
      if (!any) continue;
      glm::dmat3& stretch = out.stretches.emplace_back(0.0);
      for (const Influence& i : weights) stretch += stretches[i.joint] * i.weight;
    }
    return out;
  }

  // Stiff parts keep the shape that joints give them, where the body has their middle.
  void stiffen(const Positions& by_joints, Positions& out) const {
    for (const std::vector<std::uint32_t>& part : stiff) {
      glm::dvec3 away(0);
      for (const std::uint32_t v : part) away += out[v] - by_joints[v];
      away /= static_cast<double>(part.size());
      for (const std::uint32_t v : part) out[v] = by_joints[v] + away;
    }
  }

  const SkinnedMesh& mesh;
  Body body;
  Embedding embedding;
  std::vector<std::vector<std::uint32_t>> stiff;  // parts
  Deformer by_rig;
  std::uint32_t heaviest = 0;
  std::vector<std::uint32_t> followed;  // ascending
};

Elastic::Elastic(const SkinnedMesh& mesh, const ElasticOptions& options, std::size_t cells)
    : parts_(std::make_unique<Parts>(mesh, options, cells > 0 ? cells : cells_for(mesh.positions.size()))) {}
Elastic::~Elastic() = default;

const std::vector<double>& Elastic::rig_shares() const {
  return parts_->embedding.rig_shares();
}

const Body& Elastic::body() const {
  return parts_->body;
}

void Elastic::pose(const Pose& pose, Positions& out) const {
  const Parts& parts = *parts_;
  if (!parts.can_be_posed(pose)) {
    parts.by_rig(pose, out);
    return;
  }
  const Lattice& lattice = parts.body.lattice;
  const Motion motion(pose[parts.heaviest], lattice.origin);
  Pose placed;
  for (const Matrix& m : pose) placed.push_back(motion.without(m, lattice.side));
  const std::vector<glm::dquat> rotations = rotations_of(placed);
  const Carried carried = parts.carry(placed, rotations);
  const Shape shape = find_shape(parts.body, carried);
  out.resize(parts.mesh.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const auto by_rig = [&] {
      return by_dual_quaternion(parts.mesh.influences[v], rotations, placed,
                                lattice.to_lattice(parts.mesh.positions[v]));
    };
    out[v] = motion.with(parts.embedding.place_of(v, shape, carried, by_rig), lattice.side);
  }
  if (!deform::is_finite(out)) {
    parts.by_rig(pose, out);
  } else if (!parts.stiff.empty()) {
    Positions by_joints;
    parts.by_rig(pose, by_joints);
    parts.stiffen(by_joints, out);
  }
}

std::size_t Elastic::look_at(const std::vector<Pose>& poses) {
  const SkinnedMesh& mesh = parts_->mesh;
  const MeshParts connected(mesh);
  std::vector<std::uint32_t> of_one_joint;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (!mesh.influences[v].empty() && largest(mesh.influences[v]).weight >= kOneJoint) of_one_joint.push_back(v);
  const double most = kMostPulled * diagonal(mesh);
  struct Seen {
    std::vector<char> pulled;
    std::vector<double> by_body, by_joints;  // how much parts stretch
  };
  std::vector<Seen> seen(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Positions by_body, by_rig;
    pose(poses[i], by_body);
    parts_->by_rig(poses[i], by_rig);
    seen[i] = {std::vector<char>(mesh.positions.size(), 0), connected.stretches(by_body), connected.stretches(by_rig)};
    for (const std::uint32_t v : of_one_joint) seen[i].pulled[v] = glm::length(by_body[v] - by_rig[v]) > most;
  });
  std::vector<char> any(mesh.positions.size(), 0);
  for (const Seen& one : seen)
    for (const std::uint32_t v : of_one_joint)
      if (one.pulled[v] != 0) any[v] = 1;
  const auto count = static_cast<std::size_t>(std::ranges::count(any, 1));
  if (count > 0) parts_->embedding.leave_to_rig(any);
  for (std::size_t p = 0; p < connected.vertices().size(); ++p) {
    double by_body = 0, by_joints = 0;
    for (const Seen& one : seen) {
      by_body += one.by_body[p];
      by_joints += one.by_joints[p];
    }
    if (by_body > kSeen * kSeen * static_cast<double>(poses.size()) && by_joints < kStiff * kStiff * by_body)
      parts_->stiff.push_back(connected.vertices()[p]);
  }
  return count;
}

Deformer elastic(const SkinnedMesh& mesh, const ElasticOptions& options, const std::vector<Pose>& poses,
                 std::vector<double>* rig_shares) {
  const auto made = std::make_shared<Elastic>(mesh, options);
  made->look_at(poses);
  if (rig_shares != nullptr) *rig_shares = made->rig_shares();
  return [made](const Pose& pose, Positions& out) { made->pose(pose, out); };
}

}  // namespace marrow::deform
