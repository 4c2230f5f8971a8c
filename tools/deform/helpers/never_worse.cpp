#include "deform/helpers/never_worse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/look/folds.h"

namespace marrow::deform {
namespace {

constexpr double kRounding = 1e-9;  // of SSD's squares, and of the diagonal

// Of each vertex the number of its set of joints.
std::vector<std::size_t> sets_of_joints(const SkinnedMesh& mesh) {
  std::map<std::vector<std::uint32_t>, std::size_t> numbers;
  std::vector<std::size_t> out;
  for (const std::vector<Influence>& vertex : mesh.influences) {
    std::vector<std::uint32_t> joints;
    for (const Influence& i : vertex) joints.push_back(i.joint);
    out.push_back(numbers.try_emplace(std::move(joints), numbers.size()).first->second);
  }
  return out;
}

// A pose's squared distances from the truth, summed.
struct Distances {
  double ssd = 0;             // of all vertices by linear blend skinning
  double allowed = 0;         // what may be added to them
  double added = 0;           // what the coordinates add
  std::vector<double> parts;  // the same, of each set of joints that still has them
};

double squares(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::dot(a - b, a - b);
}

// The set that adds most to the pose that is farthest beyond what it may be; the number of sets if none is.
std::size_t to_blame(const std::vector<Distances>& poses, std::size_t sets) {
  const auto beyond = [](const Distances& d) { return d.added - d.allowed; };
  const auto worst = std::ranges::max_element(poses, {}, beyond);
  if (worst == poses.end() || !(beyond(*worst) > 0)) return sets;
  const auto most = std::ranges::max_element(worst->parts);
  return *most > 0 ? static_cast<std::size_t>(most - worst->parts.begin()) : sets;
}

}  // namespace

std::vector<char> better_by_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                const std::vector<Helper>& helpers, std::size_t poses,
                                const std::function<Pose(std::size_t)>& pose, const Deformer& truth) {
  const std::vector<std::size_t> set_of = sets_of_joints(mesh);
  const std::size_t vertices = mesh.positions.size();
  const std::size_t sets = vertices > 0 ? *std::ranges::max_element(set_of) + 1 : 0;
  const Deformer plain = ssd(mesh), ours = animation_space(coordinates);
  const double rounding = kRounding * diagonal(mesh);
  std::vector<Distances> distances(poses);
  tools::for_each_in_parallel(poses, [&](std::size_t i) {
    Positions wanted, blended, got;
    Pose at = pose(i);
    truth(at, wanted);
    plain(at, blended);
    append_helpers(helpers, at);
    ours(at, got);
    Distances& d = distances[i];
    d.parts.assign(sets, 0.0);
    for (std::size_t v = 0; v < vertices; ++v) {
      d.ssd += squares(blended[v], wanted[v]);
      d.parts[set_of[v]] += squares(got[v], wanted[v]) - squares(blended[v], wanted[v]);
    }
    if (!std::isfinite(d.ssd)) d = {0, 0, 0, std::vector<double>(sets, 0.0)};
    d.allowed = static_cast<double>(vertices) * rounding * rounding + kRounding * d.ssd;
    for (const double part : d.parts) d.added += part;
  });
  std::vector<char> goes_back(sets, 0);
  for (std::size_t set = to_blame(distances, sets); set < sets; set = to_blame(distances, sets)) {
    goes_back[set] = 1;
    for (Distances& d : distances) {
      d.added -= d.parts[set];
      d.parts[set] = 0;
    }
  }
  std::vector<char> out(vertices);
  for (std::size_t v = 0; v < vertices; ++v) out[v] = goes_back[set_of[v]];
  return out;
}

namespace {

constexpr double kMore = 1.25;
constexpr double kUnseen = 0.5;       // of an edge turned by 60°, a pose
constexpr double kUnseenJump = 1e-3;  // of the posed diagonal
constexpr int kWider = 2;             // rings of neighbours
constexpr int kSeam = 6;              // steps of smoothing behind that

enum : std::size_t { kPlain, kSimple, kOurs, kKinds };
using Sums = std::array<std::vector<double>, kKinds>;  // of vertices

// Added up in parts and in order, so that sums do not depend on threads.
Sums sums_over(const SkinnedMesh& mesh, const std::array<Deformer, kKinds>& deformers,
               const std::vector<Helper>& helpers, const std::vector<Pose>& poses) {
  constexpr std::size_t kParts = 16;
  const FoldMeter meter(mesh);
  std::vector<Sums> parts(kParts);
  tools::for_each_in_parallel(kParts, [&](std::size_t part) {
    for (std::vector<double>& sums : parts[part]) sums.assign(mesh.positions.size(), 0);
    for (std::size_t i = part; i < poses.size(); i += kParts) {
      Pose extended = poses[i];
      append_helpers(helpers, extended);
      Positions positions;
      for (std::size_t kind = 0; kind < kKinds; ++kind) {
        deformers[kind](extended, positions);
        meter.add_at_vertices(poses[i], positions, parts[part][kind]);
      }
    }
  });
  Sums out = parts.front();
  for (std::size_t part = 1; part < kParts; ++part)
    for (std::size_t kind = 0; kind < kKinds; ++kind)
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) out[kind][v] += parts[part][kind][v];
  return out;
}

// Of each vertex the largest over all frames, each in diagonals of what it shows.
Sums jumps_over(const SkinnedMesh& mesh, const std::array<Deformer, kKinds>& deformers,
                const std::vector<Helper>& helpers, const std::vector<FramesInARow>& frames) {
  std::vector<Sums> each(frames.size());
  tools::for_each_in_parallel(frames.size(), [&](std::size_t i) {
    double size = 0;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      std::array<Positions, 3> at;
      for (std::size_t k = 0; k < 3; ++k) {
        Pose pose = frames[i][k];
        append_helpers(helpers, pose);
        deformers[kind](pose, at[k]);
      }
      if (kind == kPlain) {
        SkinnedMesh shown;
        shown.positions = at[1];
        size = diagonal(shown);
      }
      for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        each[i][kind].push_back(size > 0 ? glm::length(at[0][v] - at[1][v] * 2.0 + at[2][v]) / size : 0);
    }
  });
  Sums out;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    out[kind].assign(mesh.positions.size(), 0);
    for (const Sums& one : each)
      for (std::size_t v = 0; v < out[kind].size(); ++v) out[kind][v] = std::max(out[kind][v], one[kind][v]);
  }
  return out;
}

}  // namespace

Ugliness uglier_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates, const Coordinates& simple,
                         const std::vector<Helper>& helpers, const std::vector<Pose>& poses) {
  const Sums sums = sums_over(mesh, {ssd(mesh), animation_space(simple), animation_space(coordinates)}, helpers, poses);
  Ugliness out;
  std::vector<double>& back = out.goes_back;
  back.assign(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < back.size(); ++v) {
    out.total += sums[kOurs][v];
    const double most = std::max(sums[kPlain][v], sums[kSimple][v]);
    if (sums[kOurs][v] > kMore * most + kUnseen * static_cast<double>(poses.size())) back[v] = 1;
  }
  soften(Surface(mesh), kWider, kSeam, back);
  return out;
}

std::vector<double> jumps_more_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                        const Coordinates& simple, const std::vector<Helper>& helpers,
                                        const std::vector<FramesInARow>& frames) {
  const Sums jumps =
      jumps_over(mesh, {ssd(mesh), animation_space(simple), animation_space(coordinates)}, helpers, frames);
  std::vector<double> back(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < back.size(); ++v)
    if (jumps[kOurs][v] > kMore * std::max(jumps[kPlain][v], jumps[kSimple][v]) + kUnseenJump) back[v] = 1;
  soften(Surface(mesh), kWider, kSeam, back);
  return back;
}

}  // namespace marrow::deform
