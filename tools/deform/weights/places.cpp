#include "deform/weights/places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace marrow::deform {

Places places_of(const Positions& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) { return std::tie(positions[v].x, positions[v].y, positions[v].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  Places out;
  out.of_vertex.resize(positions.size());
  for (const std::uint32_t v : order) {
    if (out.positions.empty() || out.positions.back() != positions[v]) out.positions.push_back(positions[v]);
    out.of_vertex[v] = static_cast<std::uint32_t>(out.positions.size() - 1);
  }
  return out;
}

std::vector<std::uint32_t> indices_of(const Places& places, std::span<const std::uint32_t> indices) {
  std::vector<std::uint32_t> out;
  out.reserve(indices.size());
  for (const std::uint32_t i : indices) out.push_back(places.of_vertex[i]);
  return out;
}

}  // namespace marrow::deform
