#include "deform/weights/places.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

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

PlaceTree::PlaceTree(Positions places) : places_(std::move(places)), order_(places_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  build(0, order_.size(), 0);
}

void PlaceTree::build(std::size_t first, std::size_t end, int axis) {
  if (end - first < 2) return;
  const std::size_t middle = first + (end - first) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(places_[a][axis], a) < std::pair(places_[b][axis], b);
  });
  build(first, middle, (axis + 1) % 3);
  build(middle + 1, end, (axis + 1) % 3);
}

void PlaceTree::search(std::size_t first, std::size_t end, int axis, const glm::dvec3& to, std::optional<Found>& best,
                       double& within) const {
  if (first >= end) return;
  const std::size_t middle = first + (end - first) / 2;
  const std::uint32_t here = order_[middle];
  const double distance = glm::distance(places_[here], to);
  if (distance < within || (distance == within && (!best || here < best->index))) {
    best = Found{here, distance};
    within = distance;
  }
  const double beyond = to[axis] - places_[here][axis];
  const auto lower = [&] { search(first, middle, (axis + 1) % 3, to, best, within); };
  const auto upper = [&] { search(middle + 1, end, (axis + 1) % 3, to, best, within); };
  if (beyond < 0) {
    lower();
    if (-beyond <= within) upper();
  } else {
    upper();
    if (beyond <= within) lower();
  }
}

std::optional<PlaceTree::Found> PlaceTree::nearest(const glm::dvec3& to, double within) const {
  std::optional<Found> best;
  search(0, order_.size(), 0, to, best, within);
  return best;
}

}  // namespace marrow::deform
