#include "deform/elastic/elastic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "common/distinct.h"
#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/elastic/rounds.h"
#include "deform/rotations.h"
#include "deform/surface.h"
#include "deform/weights/places.h"

namespace marrow::deform {
namespace {

constexpr double kStrange = 0.55, kAgrees = 0.80;  // of weights that are in common
constexpr int kSeam = 4;                           // steps that the border of what goes with joints is smoothed by

// Of each vertex the surface that it belongs to: vertices in one place belong to one.
std::vector<std::uint32_t> surfaces_of(const SkinnedMesh& mesh) {
  const Places places = places_of(mesh.positions);
  Unions joined(places.positions.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    joined.unite(places.of_vertex[mesh.indices[i]], places.of_vertex[mesh.indices[i - i % 3]]);
  std::vector<std::uint32_t> out;
  for (const std::uint32_t place : places.of_vertex) out.push_back(joined.root(place));
  return out;
}

using Weights = std::map<std::uint32_t, double>;

double in_common(const std::vector<Influence>& a, const Weights& b, double over) {
  double out = 0;
  for (const Influence& i : a)
    if (const auto found = b.find(i.joint); found != b.end()) out += std::min(found->second / over, i.weight);
  return out;
}

// Of each vertex what its weights have in common with those of the other surfaces in its cell, of the one with the
// least; 1 where it is alone.
std::vector<double> agreement(const Lattice& lattice, const SkinnedMesh& mesh) {
  struct Part {
    Weights weights;
    double count = 0;
  };
  const std::vector<std::uint32_t> surface = surfaces_of(mesh);
  std::vector<std::map<std::uint32_t, Part>> parts(lattice.cells.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (lattice.cell_of[v] == Lattice::kNone) continue;
    Part& part = parts[lattice.cell_of[v]][surface[v]];
    for (const Influence& i : mesh.influences[v]) part.weights[i.joint] += i.weight;
    ++part.count;
  }
  std::vector<double> out(surface.size(), 1);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (lattice.cell_of[v] == Lattice::kNone) continue;
    for (const auto& [other, part] : parts[lattice.cell_of[v]])
      if (other != surface[v]) out[v] = std::min(out[v], in_common(mesh.influences[v], part.weights, part.count));
  }
  return out;
}

}  // namespace

// A vertex goes with the corners round it, by how each is moved, turned and stretched: v' = Σ φ (x + F (v - p)), φ
// quadratic B-splines, over the corners of its own cell and of those that touch it and hang together with it. What is
// thin goes with the joints and with how far the corners are from where joints have them.
class EmbeddedMesh {
 public:
  // Refers to both.
  EmbeddedMesh(const Body& body, const SkinnedMesh& mesh);

  // Of each vertex how much of it goes with the joints alone: 1 where there is no body, or where another surface in its
  // cell follows other joints and the body is between both: clothes over skin. Smooth over the surface.
  const std::vector<double>& rig_shares() const { return rig_; }

  // From now on these vertices go with the joints alone, and those round them partly, without a seam.
  void leave_to_rig(const std::vector<char>& vertices);

  // All in the lattice's places. by_rig: where joints alone take a vertex.
  template <class ByRig>
  glm::dvec3 place_of(std::size_t v, const BodyShape& shape, const Carried& carried, const ByRig& by_rig) const {
    if (rig_[v] >= 1) return by_rig();
    glm::dvec3 whole(0), moved(0);
    double sum = 0;
    const glm::dvec3 p = body_.lattice.to_lattice(mesh_.positions[v]);
    for_each_near(v, [&](std::uint32_t n, double share) {
      const glm::dvec3 x = place(shape.places[n]), from = p - glm::dvec3(body_.lattice.nodes[n]);
      whole += (x + place(shape.gradients[n][0]) * from.x + place(shape.gradients[n][1]) * from.y +
                place(shape.gradients[n][2]) * from.z) *
               share;
      moved += (x - carried.places[n]) * share;
      sum += share;
    });
    const double rig = rig_[v], thin = (1 - rig) * thin_[v];
    glm::dvec3 out = whole * ((1 - rig - thin) / sum);
    if (rig + thin > 0) out += by_rig() * (rig + thin) + moved * (thin / sum);
    return out;
  }

 private:
  struct Near {
    std::uint32_t node;
    std::uint8_t x, y, z;  // of its place, less that of the vertex's cell, and 1 more: 0 … 3
  };
  static glm::dvec3 place(const Four& f) {
    return {static_cast<double>(f.v[0]), static_cast<double>(f.v[1]), static_cast<double>(f.v[2])};
  }

  // Calls each(node, share) for those whose share is above 0.
  template <class Each>
  void for_each_near(std::size_t v, const Each& each) const {
    const std::uint32_t c = body_.lattice.cell_of[v];
    const glm::dvec3 t = body_.lattice.to_lattice(mesh_.positions[v]) - glm::dvec3(body_.lattice.cells[c].at);
    double spline[3][4];
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i) spline[axis][i] = quadratic(t[axis] + 1 - i);
    for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) {
      const Near& near = near_[i];
      const double share = spline[0][near.x] * spline[1][near.y] * spline[2][near.z];
      if (share > 0) each(near.node, share);
    }
  }
  static double quadratic(double t);
  void find_near(std::uint32_t cell, const std::vector<char>& has_vertex);
  void find_shares();

  const Body& body_;
  const SkinnedMesh& mesh_;
  std::vector<std::size_t> first_;  // of a cell's near nodes, and the end
  std::vector<Near> near_;
  std::vector<double> rig_, thin_;  // of a vertex
};

double EmbeddedMesh::quadratic(double t) {
  const double away = std::abs(t);
  if (away < 0.5) return 0.75 - away * away;
  return away < 1.5 ? 0.5 * (1.5 - away) * (1.5 - away) : 0;
}

EmbeddedMesh::EmbeddedMesh(const Body& body, const SkinnedMesh& mesh) : body_(body), mesh_(mesh) {
  std::vector<char> has_vertex(body.lattice.cells.size(), 0);
  for (const std::uint32_t c : body.lattice.cell_of)
    if (c != Lattice::kNone) has_vertex[c] = 1;
  first_.push_back(0);
  for (std::uint32_t c = 0; c < body.lattice.cells.size(); ++c) find_near(c, has_vertex);
  find_shares();
}

// Cells that touch are at most three steps across faces away.
void EmbeddedMesh::find_near(std::uint32_t cell, const std::vector<char>& has_vertex) {
  const std::vector<Lattice::Cell>& cells = body_.lattice.cells;
  if (has_vertex[cell] != 0) {
    const glm::ivec3 at = cells[cell].at;
    std::vector<std::uint32_t> reached = {cell};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const std::uint32_t b : cells[reached[i]].beside) {
        if (b == Lattice::kNone || std::ranges::find(reached, b) != reached.end()) continue;
        const glm::ivec3 away = glm::abs(cells[b].at - at);
        if (std::max({away.x, away.y, away.z}) <= 1) reached.push_back(b);
      }
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t c : reached) nodes.insert(nodes.end(), cells[c].nodes.begin(), cells[c].nodes.end());
    tools::make_distinct(nodes);
    for (const std::uint32_t n : nodes) {
      const glm::ivec3 from = body_.lattice.nodes[n] - at + 1;
      near_.push_back(
          {n, static_cast<std::uint8_t>(from.x), static_cast<std::uint8_t>(from.y), static_cast<std::uint8_t>(from.z)});
    }
  }
  first_.push_back(near_.size());
}

void EmbeddedMesh::find_shares() {
  const std::size_t count = mesh_.positions.size();
  rig_.assign(count, 1);
  thin_.assign(count, 0);
  const std::vector<double> agrees = agreement(body_.lattice, mesh_);
  for (std::size_t v = 0; v < count; ++v) {
    if (body_.lattice.cell_of[v] == Lattice::kNone) continue;
    Weights weights;
    double sum = 0, filled = 0;
    for_each_near(v, [&](std::uint32_t n, double share) {
      for (const Influence& i : body_.weights[n]) weights[i.joint] += i.weight * share;
      filled += static_cast<double>(body_.lattice.filled_around[n]) * share;
      sum += share;
    });
    const double common = in_common(mesh_.influences[v], weights, sum);
    // Where one surface goes over from joint to joint at once the lattice is smoother, as it should be.
    rig_[v] = 1 - smooth_step(std::max(common, agrees[v]), kStrange, kAgrees);
    thin_[v] = 1 - smooth_step(filled / sum, kThin, kThick);
  }
  soften(Surface(mesh_), 1, kSeam, rig_);
  for (std::size_t v = 0; v < count; ++v)
    if (body_.lattice.cell_of[v] == Lattice::kNone) rig_[v] = 1;
}

void EmbeddedMesh::leave_to_rig(const std::vector<char>& vertices) {
  std::vector<double> shares(vertices.begin(), vertices.end());
  soften(Surface(mesh_), kSeam, kSeam, shares);
  for (std::size_t v = 0; v < shares.size(); ++v) rig_[v] = std::max(rig_[v], shares[v]);
}

namespace {

constexpr double kOneJoint = 0.97;    // of a weight
constexpr double kMostPulled = 0.02;  // of the diagonal
constexpr double kStretches = 1e-6;   // joints that are stretched less are not
constexpr double kStiff = 0.6;        // of how much the body stretches a part: what joints stretch a stiff one at most
constexpr double kSeen = 0.002;       // of lengths: a part that the body stretches less in the mean is none to see

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
  EmbeddedMesh embedding;
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
  const BodyShape shape = find_shape(parts.body, carried);
  out.resize(parts.mesh.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const auto by_rig = [&] {
      return by_dual_quaternion(parts.mesh.influences[v], rotations, placed,
                                lattice.to_lattice(parts.mesh.positions[v]));
    };
    out[v] = motion.with(parts.embedding.place_of(v, shape, carried, by_rig), lattice.side);
  }
  if (!is_finite(out)) {
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
