#include "cook/skin/skin_binding.h"

#include <algorithm>
#include <map>
#include <string>

#include "marrow/file.h"

namespace marrow::cook {
namespace {

BoundVertex largest_influences(const std::vector<RawInfluence>& raw, std::size_t& dropped) {
  std::map<std::uint32_t, double> merged;
  for (const RawInfluence& i : raw)
    if (i.weight > 0) merged[i.joint] += static_cast<double>(i.weight);
  BoundVertex kept;
  for (const auto& [joint, weight] : merged) kept.push_back({joint, weight});
  if (kept.size() > kMaxInfluences) {
    std::ranges::stable_sort(kept, std::ranges::greater(), &BoundInfluence::weight);
    kept.resize(kMaxInfluences);
    std::ranges::sort(kept, {}, &BoundInfluence::joint);
    ++dropped;
  }
  double sum = 0;
  for (const BoundInfluence& i : kept) sum += i.weight;
  for (BoundInfluence& i : kept) i.weight /= sum;
  if (kept.empty()) kept.push_back({0, 1.0});
  return kept;
}

}  // namespace

SkinBinding bind_to_skin(const RawMesh& mesh, Notes& notes) {
  SkinBinding out;
  for (const RawPrimitive& primitive : mesh.primitives) {
    std::vector<BoundVertex>& vertices = out.primitives.emplace_back();
    std::size_t dropped = 0, unbound = 0;
    for (const std::vector<RawInfluence>& raw : primitive.influences) {
      unbound += std::ranges::none_of(raw, [](const RawInfluence& i) { return i.weight > 0; });
      vertices.push_back(largest_influences(raw, dropped));
    }
    if (dropped > 0)
      notes.warnings.push_back(
          {primitive.pointer, "influences-dropped",
           std::to_string(dropped) + " vertices had more than 8 influences; the 8 largest are kept and renormalised"});
    if (unbound > 0)
      notes.warnings.push_back(
          {primitive.pointer, "weights-zero",
           std::to_string(unbound) + " vertices had no weight above 0; they follow the skin's first joint"});
  }
  out.part_of.resize(mesh.primitives.size());
  return out;
}

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
