#include "deform/helpers/not_uglier.h"

#include <algorithm>

#include "common/parallel.h"
#include "deform/deformers.h"
#include "deform/look/folds.h"

namespace marrow::deform {
namespace {

constexpr double kMore = 1.1;    // of linear blend skinning's
constexpr double kUnseen = 0.1;  // of an edge turned by 60°, a pose: that much more nobody sees
constexpr int kWider = 2;        // rings of neighbours
constexpr int kSeam = 6;         // steps of smoothing behind that

}  // namespace

std::vector<double> uglier_than_ssd(const SkinnedMesh& mesh, const Coordinates& coordinates,
                                    const std::vector<Helper>& helpers, std::size_t poses,
                                    const std::function<Pose(std::size_t)>& pose) {
  constexpr std::size_t kParts = 16;  // whose sums are added up in order
  const FoldMeter meter(mesh);
  const Deformer plain = ssd(mesh), ours = animation_space(coordinates);
  std::vector<std::vector<double>> by_plain(kParts), by_ours(kParts);
  tools::for_each_in_parallel(kParts, [&](std::size_t part) {
    for (std::size_t i = part; i < poses; i += kParts) {
      Pose at = pose(i);
      Positions positions;
      plain(at, positions);
      meter.add_at_vertices(at, positions, by_plain[part]);
      const Pose joints = at;
      append_helpers(helpers, at);
      ours(at, positions);
      meter.add_at_vertices(joints, positions, by_ours[part]);
    }
  });
  std::vector<double> out(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < out.size(); ++v) {
    double first = 0, second = 0;
    for (std::size_t part = 0; part < std::min(kParts, poses); ++part) {
      first += by_plain[part][v];
      second += by_ours[part][v];
    }
    if (second > kMore * first + kUnseen * static_cast<double>(poses)) out[v] = 1;
  }
  const Surface surface(mesh);
  std::vector<double> scratch;
  for (int ring = 0; ring < kWider; ++ring) {
    scratch = out;
    for (std::size_t v = 0; v < out.size(); ++v)
      for (const std::uint32_t k : surface.neighbours(v)) out[v] = std::max(out[v], scratch[k]);
  }
  for (int i = 0; i < kSeam; ++i) surface.smooth(out, 0.5, scratch);
  return out;
}

}  // namespace marrow::deform
