#include "cook/geometry/order_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::cook {
namespace {

// A vertex cache that forgets what came first.
class Cache {
 public:
  explicit Cache(std::size_t vertex_count) : loaded_(vertex_count, 0) {}
  void clear() { loads_ += kSize + 1; }
  // How many of a triangle's vertices are not in it, and now are.
  std::uint32_t misses(const std::uint32_t* corners) {
    std::uint32_t count = 0;
    for (int c = 0; c < 3; ++c) {
      if (loads_ - loaded_[corners[c]] <= kSize) continue;
      loaded_[corners[c]] = loads_++;
      ++count;
    }
    return count;
  }

 private:
  static constexpr std::uint64_t kSize = 16;
  std::uint64_t loads_ = kSize + 1;
  std::vector<std::uint64_t> loaded_;  // when, counted in loads
};

// First triangles of parts, and behind them the number of triangles.
using Cuts = std::vector<std::size_t>;

// Where none of a triangle's vertices was there, a cut costs nothing.
Cuts free_cuts(std::span<const std::uint32_t> indices, Cache& cache) {
  const std::size_t triangles = indices.size() / 3;
  Cuts cuts;
  for (std::size_t t = 0; t < triangles; ++t)
    if (cache.misses(&indices[3 * t]) == 3 || t == 0) cuts.push_back(t);
  cuts.push_back(triangles);
  return cuts;
}

// Cuts the part from `first` to `end` wherever it has loaded few enough vertices a triangle. What is left at the end
// stays with the last.
void cut_further(std::span<const std::uint32_t> indices, std::size_t first, std::size_t end, float most_misses,
                 Cache& cache, Cuts& cuts) {
  cache.clear();
  std::uint32_t all = 0;
  for (std::size_t t = first; t < end; ++t) all += cache.misses(&indices[3 * t]);
  const float most = most_misses * (static_cast<float>(all) / static_cast<float>(end - first));
  cache.clear();
  cuts.push_back(first);
  std::uint32_t misses = 0, triangles = 0;
  for (std::size_t t = first; t < end; ++t) {
    misses += cache.misses(&indices[3 * t]);
    ++triangles;
    if (static_cast<float>(misses) / static_cast<float>(triangles) > most) continue;
    cuts.push_back(t + 1);
    cache.clear();
    misses = triangles = 0;
  }
  if (cuts.back() != first) cuts.pop_back();
}

struct Surface {
  std::span<const std::uint32_t> indices;
  std::span<const float> positions;
  glm::vec3 corner(std::size_t i) const {
    const float* const p = &positions[std::size_t{3} * indices[i]];
    return {p[0], p[1], p[2]};
  }
};

glm::vec3 middle_of_corners(const Surface& surface) {
  glm::vec3 sum(0);
  for (std::size_t i = 0; i < surface.indices.size(); ++i) sum += surface.corner(i);
  return sum / static_cast<float>(surface.indices.size());
}

// How far the part lies on the side that it faces.
float outwardness(const Surface& surface, std::size_t first, std::size_t end, const glm::vec3& middle) {
  glm::vec3 centre(0), normal(0);
  float area = 0;
  for (std::size_t t = first; t < end; ++t) {
    const glm::vec3 a = surface.corner(3 * t), b = surface.corner(3 * t + 1), c = surface.corner(3 * t + 2);
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float size = glm::length(across);
    centre += (a + b + c) * (size / 3);
    normal += across;
    area += size;
  }
  const float length = glm::length(normal);
  centre *= area > 0 ? 1 / area : 0.0f;
  normal *= length > 0 ? 1 / length : 0.0f;
  return glm::dot(centre - middle, normal);
}

// As whole numbers, so that parts that are much alike stay in the order that the cache likes.
std::vector<int> in_steps(const std::vector<float>& values) {
  constexpr float kMost = 2047;
  float largest = 1e-3f;
  for (const float v : values) largest = std::max(largest, std::abs(v));
  std::vector<int> out;
  for (const float v : values) out.push_back(static_cast<int>((0.5f - 0.5f * (v / largest)) * kMost + 0.5f));
  return out;
}

}  // namespace

std::vector<std::uint32_t> outer_parts_first(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                             float most_misses) {
  Cache cache(positions.size() / 3);
  const Cuts free = free_cuts(indices, cache);
  Cuts cuts;
  for (std::size_t i = 0; i + 1 < free.size(); ++i)
    cut_further(indices, free[i], free[i + 1], most_misses, cache, cuts);
  cuts.push_back(indices.size() / 3);

  const Surface surface{indices, positions};
  const glm::vec3 middle = middle_of_corners(surface);
  std::vector<float> outward;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    outward.push_back(outwardness(surface, cuts[i], cuts[i + 1], middle));
  const std::vector<int> inward = in_steps(outward);
  std::vector<std::size_t> order(outward.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return inward[a] < inward[b]; });

  std::vector<std::uint32_t> out;
  for (const std::size_t i : order) out.insert(out.end(), &indices[3 * cuts[i]], indices.data() + 3 * cuts[i + 1]);
  return out;
}

}  // namespace marrow::cook
