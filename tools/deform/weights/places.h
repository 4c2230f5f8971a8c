// Vertices at one place as one, since seams part a mesh's vertices and not its surface; and the nearest of many places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Places {
  std::vector<std::uint32_t> of_vertex;
  Positions positions;  // of places, ascending
};
Places places_of(const Positions& positions);

// Triangles of places.
std::vector<std::uint32_t> indices_of(const Places& places, std::span<const std::uint32_t> indices);

class PlaceTree {
 public:
  // Coordinates are finite. Cost: n log n.
  explicit PlaceTree(Positions places);

  struct Found {
    std::uint32_t index;  // of `places`
    double distance;
  };
  // No farther than `within`; of equally near ones the first. Cost: log n, as a rule.
  std::optional<Found> nearest(const glm::dvec3& to, double within) const;

 private:
  void build(std::size_t first, std::size_t end, int axis);
  void search(std::size_t first, std::size_t end, int axis, const glm::dvec3& to, std::optional<Found>& best,
              double& within) const;

  Positions places_;
  std::vector<std::uint32_t> order_;  // the middle of each range divides it
};

}  // namespace marrow::deform
