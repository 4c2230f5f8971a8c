#include "deform/weights/place_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace marrow::deform {

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
