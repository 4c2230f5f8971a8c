// Distances in animation space that hold over all poses, and vertices with fewer joints that are closest by them.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "deform/animation_space.h"

namespace marrow::deform {

// E‖Σ_j M_j (p_j - q_j)‖² = (p - q)ᵀ P (p - q), P_ij = E[M_iᵀ M_j], in 4 × 4 blocks: an average over poses, computed
// without posing anything (Merry, Marais and Gain 2006, section 5).
class PoseMetric {
 public:
  // Of pairs of joints that a vertex of `coordinates` follows both of. Poses count alike; those that are not finite are
  // left out. Memory: 128 bytes a pair. Cost: pairs times poses.
  PoseMetric(const std::vector<Pose>& poses, const Coordinates& coordinates);

  // Between vertices that follow joints of one vertex of those coordinates, weights of both summing to the same.
  double squared_distance(const std::vector<Coordinate>& p, const std::vector<Coordinate>& q) const;
  // P_ij; precondition: one of the pairs. Each pose's translations are taken from their mean over joints, which makes
  // no difference to differences and spares digits.
  glm::dmat4 block(std::uint32_t i, std::uint32_t j) const;

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, glm::dmat4> blocks_;  // i ≤ j
};

// The `most` joints that a vertex can best do with: while there are more, the one goes whose part another moves most
// alike.
std::vector<std::uint32_t> joints_to_keep(const PoseMetric& metric, const std::vector<Coordinate>& vertex,
                                          std::size_t most);

// Closest to a vertex, of those that follow `joints` alone and leave it where it is in the bind pose. Precondition:
// joints of the vertex, ascending, at least one.
std::vector<Coordinate> with_joints(const PoseMetric& metric, const std::vector<Coordinate>& vertex,
                                    const std::vector<std::uint32_t>& joints);

// The same for linear blend skinning: weights ≥ 0 on `joints`, some maybe left out.
std::vector<Influence> with_joints(const PoseMetric& metric, const glm::dvec3& position,
                                   const std::vector<Influence>& influences, const std::vector<std::uint32_t>& joints);

}  // namespace marrow::deform
