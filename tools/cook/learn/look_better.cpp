#include "cook/learn/look_better.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/evenly.h"
#include "deform/helpers/never_worse.h"
#include "deform/surface.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostPoses = 128;  // of clips, and beyond
constexpr int kRounds = 2;               // as where it has given way something else may

// The closed form over the joints and helpers that vertices have.
deform::Coordinates simple_over(const deform::ClosedForm& form, const deform::Coordinates& coordinates) {
  deform::Coordinates out = coordinates;
  for (std::size_t v = 0; v < out.size(); ++v) {
    const auto weights = form.weights_of(v, joints_of(out[v]));
    if (!weights) continue;
    for (deform::Coordinate& c : out[v]) c.q = glm::dvec4(form.position_of(v), 1) * weight_of(c.joint, *weights);
  }
  return out;
}

void give_way(const deform::Coordinates& simple, const std::vector<double>& goes_back, deform::Coordinates& out) {
  for (std::size_t v = 0; v < out.size(); ++v)
    for (std::size_t i = 0; i < out[v].size(); ++i) out[v][i].q += (simple[v][i].q - out[v][i].q) * goes_back[v];
}

// The vertex next to the mean place.
std::uint32_t middle_of(const deform::SkinnedMesh& mesh, const std::vector<std::uint32_t>& part) {
  glm::dvec3 mean(0);
  for (const std::uint32_t v : part) mean += mesh.positions[v] / static_cast<double>(part.size());
  return *std::ranges::min_element(part, {}, [&](std::uint32_t v) { return glm::length(mesh.positions[v] - mean); });
}

}  // namespace

void keep_from_looking_worse(const DeformSource& source, const deform::ClosedForm& form,
                             const std::vector<deform::Pose>& clips, Learnt& out) {
  std::vector<deform::Pose> poses = tools::evenly(clips, kMostPoses);
  for (const deform::MotionPose& turned : tools::evenly(source.motion, kMostPoses)) poses.push_back(turned.pose());
  const deform::Coordinates simple = simple_over(form, out.coordinates);
  const auto look = [&](const deform::Coordinates& coordinates) {
    return deform::uglier_than_ssd(source.mesh, coordinates, simple, out.helpers, poses);
  };
  deform::Ugliness now = look(out.coordinates);
  for (int round = 0; round < kRounds; ++round) {
    deform::Coordinates next = out.coordinates;
    give_way(simple, now.goes_back, next);
    deform::Ugliness then = look(next);
    if (!(then.total < now.total)) break;
    out.coordinates = std::move(next);
    now = std::move(then);
  }
  give_way(simple, deform::jumps_more_than_ssd(source.mesh, out.coordinates, simple, out.helpers, source.frames),
           out.coordinates);
}

void move_stiff_parts_as_one(const deform::SkinnedMesh& mesh, Learnt& out) {
  constexpr double kSame = 1e-3;  // of weights, which sum to 1
  const deform::MeshParts parts(mesh);
  for (const std::vector<std::uint32_t>& part : parts.vertices()) {
    const std::uint32_t middle = middle_of(mesh, part);
    const auto is_as_the_middle = [&](std::uint32_t v) {
      return std::ranges::all_of(mesh.influences[middle], [&](const deform::Influence& i) {
        return std::abs(weight_of(i.joint, mesh.influences[v]) - i.weight) < kSame;
      });
    };
    if (mesh.influences[middle].empty() || !std::ranges::all_of(part, is_as_the_middle)) continue;
    const std::vector<deform::Influence> weights = out.weights[middle];
    const std::vector<deform::Coordinate> learnt = out.coordinates[middle];
    for (const std::uint32_t v : part) {
      const glm::dvec4 away(mesh.positions[v] - mesh.positions[middle], 0);
      out.weights[v] = weights;
      out.coordinates[v] = learnt;
      for (deform::Coordinate& c : out.coordinates[v]) c.q += away * weight_of(c.joint, weights);
    }
  }
}

}  // namespace marrow::cook
