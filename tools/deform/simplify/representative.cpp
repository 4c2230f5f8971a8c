#include "deform/simplify/representative.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kPairs = 256;

// Vertices far apart in order, and so mostly on the surface.
std::vector<double> lengths(const Positions& at) {
  std::vector<double> out;
  const std::size_t n = at.size();
  for (std::size_t i = 0; i < kPairs; ++i) {
    const std::size_t a = i * n / kPairs, b = (a + n / 2 + i * i) % n;
    out.push_back(glm::length(at[a] - at[b]));
  }
  return out;
}

double squared_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace

std::vector<Representative> representative_poses(const Deformer& deformer, const std::vector<Pose>& poses,
                                                 std::size_t first, std::size_t most) {
  std::vector<std::vector<double>> shapes(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Positions at;
    deformer(poses[i], at);
    if (!at.empty()) shapes[i] = lengths(at);
  });
  std::vector<Representative> out;
  std::vector<double> nearest(poses.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> of(poses.size(), 0);
  for (std::size_t next = first; out.size() < most;) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double d = squared_difference(shapes[i], shapes[next]);
      if (!(d < nearest[i])) continue;
      nearest[i] = d;
      of[i] = out.size();
    }
    out.push_back({next, 0});
    next = poses.size();
    double farthest = 0;
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (std::isfinite(nearest[i]) && nearest[i] > farthest) farthest = nearest[next = i];
    if (next == poses.size()) break;
  }
  for (std::size_t i = 0; i < poses.size(); ++i) out[of[i]].weight += 1.0 / static_cast<double>(poses.size());
  return out;
}

}  // namespace marrow::deform
