#include "cook/skin/fewer_joints.h"

#include <algorithm>

namespace marrow::cook {

std::vector<deform::Coordinate> coordinates_of(const BoundVertex& vertex, const glm::dvec3& position) {
  std::vector<deform::Coordinate> out;
  for (const BoundInfluence& i : vertex) out.push_back({i.joint, i.residual + glm::dvec4(position, 1) * i.weight});
  return out;
}

BoundVertex with_fewer_joints(const deform::PoseMetric& metric, const BoundVertex& vertex, const glm::dvec3& position,
                              bool has_residual, std::size_t most) {
  const std::vector<deform::Coordinate> coordinates = coordinates_of(vertex, position);
  const std::vector<std::uint32_t> joints = deform::joints_to_keep(metric, coordinates, most);
  std::vector<deform::Influence> influences;
  for (const BoundInfluence& i : vertex) influences.push_back({i.joint, i.weight});
  influences = deform::with_joints(metric, position, influences, joints);
  BoundVertex out;
  if (!has_residual) {
    for (const deform::Influence& i : influences) out.push_back({i.joint, i.weight});
    return out;
  }
  for (const deform::Coordinate& c : deform::with_joints(metric, coordinates, joints)) {
    const auto found = std::ranges::find(influences, c.joint, &deform::Influence::joint);
    const double weight = found == influences.end() ? 0 : found->weight;
    out.push_back({c.joint, weight, c.q - glm::dvec4(position, 1) * weight});
  }
  return out;
}

}  // namespace marrow::cook
