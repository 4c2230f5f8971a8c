#include "deform/look/folds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "deform/rotations.h"
#include "deform/surface.h"

namespace marrow::deform {
namespace {

constexpr double kBlends = 0.99;  // below that share of the heaviest joint
constexpr double kCrease_rad = std::numbers::pi / 3;

std::vector<Influence> mean_weights(const SkinnedMesh& mesh, std::span<const std::uint32_t> corners) {
  std::map<std::uint32_t, double> sums;
  for (const std::uint32_t v : corners)
    for (const Influence& i : mesh.influences[v]) sums[i.joint] += i.weight / static_cast<double>(corners.size());
  std::vector<Influence> out;
  for (const auto& [joint, weight] : sums) out.push_back({joint, weight});
  return out;
}

// Between the normals of triangles a b c and b a d; above 0 at a ridge.
double angle_between(const Positions& p, const std::array<std::uint32_t, 4>& corners) {
  const auto [a, b, c, d] = corners;
  const glm::dvec3 first = doubled_area(p, a, b, c), second = doubled_area(p, b, a, d), edge = p[b] - p[a];
  return tools::angle_of(-glm::dot(glm::cross(first, second), edge), glm::dot(first, second) * glm::length(edge));
}

}  // namespace

FoldMeter::FoldMeter(const SkinnedMesh& mesh) : mesh_(mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;  // of an edge as it runs
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* const i = &mesh.indices[t];
    weights_.push_back(mean_weights(mesh, {i, 3}));
    for (std::size_t e = 0; e < 3; ++e) opposite[{i[e], i[(e + 1) % 3]}].push_back(i[(e + 2) % 3]);
  }
  for (const auto& [ends, ours] : opposite) {
    const auto [a, b] = ends;
    const auto theirs = opposite.find({b, a});
    if (a >= b || theirs == opposite.end() || ours.size() != 1 || theirs->second.size() != 1) continue;
    const std::array<std::uint32_t, 4> corners = {a, b, ours.front(), theirs->second.front()};
    if (doubled_area(mesh.positions, a, b, corners[2]) == glm::dvec3(0) ||
        doubled_area(mesh.positions, b, a, corners[3]) == glm::dvec3(0))
      continue;
    const std::vector<Influence> weights = mean_weights(mesh, corners);
    if (weights.empty() || !(largest(weights).weight < kBlends)) continue;
    const double length = glm::length(mesh.positions[b] - mesh.positions[a]);
    edges_.push_back({corners, length, angle_between(mesh.positions, corners)});
    length_ += length;
  }
}

std::vector<glm::dvec3> FoldMeter::facing(const Pose& pose) const {
  const std::vector<glm::dquat> rotations = rotations_of(pose);
  std::vector<glm::dvec3> out(weights_.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < weights_.size(); ++t) {
    if (weights_[t].empty()) continue;
    const std::uint32_t* const i = &mesh_.indices[3 * t];
    const glm::dquat turn =
        glm::normalize(blend_rotations(weights_[t], rotations, [](const Influence&, const glm::dquat&) {}));
    out[t] = turn * doubled_area(mesh_.positions, i[0], i[1], i[2]);
  }
  return out;
}

// Calls each(triangle).
template <class Each>
void FoldMeter::for_each_flipped(const std::vector<glm::dvec3>& facing, const Positions& positions,
                                 const Each& each) const {
  for (std::size_t t = 0; t < facing.size(); ++t) {
    const std::uint32_t* const i = &mesh_.indices[3 * t];
    if (glm::dot(doubled_area(positions, i[0], i[1], i[2]), facing[t]) < 0) each(t);
  }
}

std::vector<std::size_t> FoldMeter::flipped_by_joint(const std::vector<glm::dvec3>& facing,
                                                     const Positions& positions) const {
  std::vector<std::size_t> out(mesh_.joint_count, 0);
  if (!is_finite(positions)) return out;
  for_each_flipped(facing, positions, [&](std::size_t t) { ++out[largest(weights_[t]).joint]; });
  return out;
}

double FoldMeter::turned_rad(const Edge& edge, const Positions& positions) const {
  const double turned = std::abs(angle_between(positions, edge.corners) - edge.angle_rad);
  return std::min(turned, 2 * std::numbers::pi - turned);
}

Folds FoldMeter::of(const std::vector<glm::dvec3>& facing, const Positions& positions) const {
  Folds out;
  if (!is_finite(positions)) return out;
  for_each_flipped(facing, positions, [&](std::size_t) { ++out.flipped; });
  if (!(length_ > 0)) return out;
  for (const Edge& edge : edges_) {
    const double turned = turned_rad(edge, positions);
    out.bend_rad += turned * turned * edge.length;
    if (turned > kCrease_rad) out.creased += edge.length;
  }
  out.bend_rad = std::sqrt(out.bend_rad / length_);
  out.creased /= length_;
  return out;
}

void FoldMeter::add_at_vertices(const Pose& pose, const Positions& positions, std::vector<double>& sums) const {
  sums.resize(mesh_.positions.size(), 0);
  if (!is_finite(positions)) return;
  for_each_flipped(facing(pose), positions, [&](std::size_t t) {
    for (std::size_t c = 0; c < 3; ++c) ++sums[mesh_.indices[3 * t + c]];
  });
  for (const Edge& edge : edges_) {
    const double turned = turned_rad(edge, positions) / kCrease_rad;
    for (const std::uint32_t v : edge.corners) sums[v] += turned * turned;
  }
}

double largest_jump(const SkinnedMesh& mesh, const FramesInARow& poses, const std::array<Positions, 3>& at) {
  double out = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.influences[v].empty()) continue;
    const std::uint32_t joint = largest(mesh.influences[v]).joint;
    glm::dvec3 seen[3];
    for (std::size_t k = 0; k < 3; ++k)
      seen[k] = glm::inverse(linear_of(poses[k][joint])) * (at[k][v] - poses[k][joint][3]);
    const double jump = glm::length(seen[0] - seen[1] * 2.0 + seen[2]);
    if (std::isfinite(jump)) out = std::max(out, jump);
  }
  return out;
}

}  // namespace marrow::deform
