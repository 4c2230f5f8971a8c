#include "deform/helpers/not_uglier.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/look/folds.h"

namespace marrow::deform {
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
