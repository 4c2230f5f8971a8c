#include "deform/simplify/subdivide.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "common/elementary.h"

namespace marrow::deform {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // ascending

struct Sides {
  std::vector<std::uint32_t> opposite;  // a triangle: its third point
  std::uint32_t middle = 0;             // point
};

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

Combination sum_of(std::map<std::uint32_t, double> shares) {
  Combination out;
  for (const auto& [vertex, share] : shares) out.push_back({vertex, share});
  return out;
}

Combination old_point(std::uint32_t p, const std::set<std::uint32_t>& around, const std::set<std::uint32_t>& border,
                      bool is_corner) {
  if (around.empty() || is_corner) return {{p, 1.0}};
  std::map<std::uint32_t, double> shares;
  if (!border.empty()) {
    if (border.size() != 2) return {{p, 1.0}};
    shares[p] = 0.75;
    for (const std::uint32_t q : border) shares[q] = 0.125;
    return sum_of(std::move(shares));
  }
  const auto n = static_cast<double>(around.size());
  const double part = 3.0 / 8 + tools::cosine(2 * std::numbers::pi / n) / 4, beta = (5.0 / 8 - part * part) / n;
  shares[p] = 1 - n * beta;
  for (const std::uint32_t q : around) shares[q] = beta;
  return sum_of(std::move(shares));
}

Combination middle_of(const Edge& edge, const Sides& sides) {
  if (sides.opposite.size() != 2 || sides.opposite[0] == sides.opposite[1])
    return {{edge.first, 0.5}, {edge.second, 0.5}};
  return sum_of({{edge.first, 0.375}, {edge.second, 0.375}, {sides.opposite[0], 0.125}, {sides.opposite[1], 0.125}});
}

}  // namespace

FinerSurface subdivide(const SeamedSurface& surface, std::size_t point_count) {
  const auto point = [&](std::size_t corner) { return surface.point_of[surface.indices[corner]]; };
  std::map<Edge, Sides> edges;
  std::vector<std::set<std::uint32_t>> around(point_count), border(point_count);
  std::vector<char> corner(point_count, 0);
  for (std::size_t i = 0; i < surface.indices.size(); ++i) {
    const std::size_t t = i / 3 * 3, next = t + (i + 1) % 3;
    if (point(i) == point(next)) continue;
    edges[edge_of(point(i), point(next))].opposite.push_back(point(t + (i + 2) % 3));
  }
  FinerSurface out;
  auto number = static_cast<std::uint32_t>(point_count);
  for (auto& [edge, sides] : edges) {
    sides.middle = number++;
    around[edge.first].insert(edge.second);
    around[edge.second].insert(edge.first);
    if (sides.opposite.size() == 1) {
      border[edge.first].insert(edge.second);
      border[edge.second].insert(edge.first);
    } else if (sides.opposite.size() > 2) {
      corner[edge.first] = corner[edge.second] = 1;
    }
  }
  for (std::uint32_t p = 0; p < point_count; ++p)
    out.points.push_back(old_point(p, around[p], border[p], corner[p] != 0));
  for (const auto& [edge, sides] : edges) out.points.push_back(middle_of(edge, sides));

  out.point_of = surface.point_of;
  for (std::uint32_t v = 0; v < surface.point_of.size(); ++v) out.vertices.push_back({{v, 1.0}});
  std::map<Edge, std::uint32_t> middles;  // of vertices
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t p = surface.point_of[a], q = surface.point_of[b];
    if (a == b || p == q) return a;
    const auto [at, is_new] = middles.try_emplace(edge_of(a, b), static_cast<std::uint32_t>(out.vertices.size()));
    if (!is_new) return at->second;
    out.vertices.push_back({{at->first.first, 0.5}, {at->first.second, 0.5}});
    out.point_of.push_back(edges.at(edge_of(p, q)).middle);
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
    const std::uint32_t a = surface.indices[i], b = surface.indices[i + 1], c = surface.indices[i + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t v : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) out.indices.push_back(v);
  }
  return out;
}

}  // namespace marrow::deform
