// Loop's scheme written anew, for tests to compare with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::cook {

using Corners = std::array<std::uint32_t, 3>;
using Places = std::vector<glm::dvec3>;

// Points and triangles, without seams.
struct Net {
  Places at;
  std::vector<Corners> triangles;
};

// Loop 1987, in his own form: a(n) of the point and the rest of its neighbours' mean, a(n) = (3/8 + cos(2π/n)/4)² +
// 3/8.
inline Net looped(const Net& net) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
  for (const Corners& t : net.triangles)
    for (std::size_t k = 0; k < 3; ++k) opposite[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
  Net out;
  std::vector<std::vector<std::uint32_t>> ring(net.at.size()), border(net.at.size());
  for (const auto& [edge, ends] : opposite) {
    const auto& [a, b] = edge;
    ring[a].push_back(b), ring[b].push_back(a);
    if (ends.size() == 1) border[a].push_back(b), border[b].push_back(a);
  }
  for (std::size_t p = 0; p < net.at.size(); ++p) {
    const std::vector<std::uint32_t>& around = border[p].empty() ? ring[p] : border[p];
    glm::dvec3 mean(0);
    for (const std::uint32_t q : around) mean += net.at[q] / static_cast<double>(around.size());
    const double part = 3.0 / 8 + std::cos(2 * std::numbers::pi / static_cast<double>(around.size())) / 4;
    const double own = around.empty() ? 1 : border[p].empty() ? part * part + 3.0 / 8 : 0.75;
    out.at.push_back(net.at[p] * own + mean * (1 - own));
  }
  for (const auto& [edge, ends] : opposite) {
    middle[edge] = static_cast<std::uint32_t>(out.at.size());
    const glm::dvec3 sum = net.at[edge.first] + net.at[edge.second];
    out.at.push_back(ends.size() == 2 ? (sum * 3.0 + net.at[ends[0]] + net.at[ends[1]]) / 8.0 : sum / 2.0);
  }
  for (const auto& [a, b, c] : net.triangles) {
    const std::uint32_t ab = middle.at(std::minmax(a, b)), bc = middle.at(std::minmax(b, c)),
                        ca = middle.at(std::minmax(c, a));
    out.triangles.insert(out.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return out;
}

// For each of `from` the nearest of `to`, which must be within `most`.
inline std::vector<std::uint32_t> nearest(const Places& from, const Places& to, double most) {
  std::vector<std::pair<double, std::uint32_t>> by_x;
  for (std::uint32_t i = 0; i < to.size(); ++i) by_x.emplace_back(to[i].x, i);
  std::ranges::sort(by_x);
  std::vector<std::uint32_t> out;
  std::size_t lost = 0;
  for (const glm::dvec3& v : from) {
    double best = most;
    std::uint32_t found = 0;
    for (auto at = std::ranges::lower_bound(by_x, std::pair(v.x - most, 0u)); at != by_x.end(); ++at) {
      if (at->first > v.x + most) break;
      const double distance = glm::length(to[at->second] - v);
      if (distance < best) best = distance, found = at->second;
    }
    lost += best == most ? 1u : 0u;
    out.push_back(found);
  }
  EXPECT_EQ(lost, 0u) << "of " << from.size();
  return out;
}

}  // namespace marrow::cook
