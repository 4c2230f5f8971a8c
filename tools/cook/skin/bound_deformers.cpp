#include "cook/skin/bound_deformers.h"

#include <algorithm>

namespace marrow::cook {
namespace {

MultiWeightData multi_weight_data(const BoundDeformers& deformers, const std::vector<std::uint32_t>& vertex_of,
                                  const std::vector<BoundVertex>& vertices,
                                  const std::vector<std::uint16_t>& entry_of) {
  MultiWeightData out;
  out.root = entry_of[deformers.root];
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::vector<deform::MultiWeight>& learnt = deformers.multi_weights[vertex_of[v]];
    auto& to = out.weights.emplace_back();
    for (const BoundInfluence& i : vertices[v]) {
      auto& twelve = to.emplace_back();  // zeros for what quantisation drops
      const auto found = std::ranges::find(learnt, i.joint, &deform::MultiWeight::joint);
      for (std::size_t n = 0; n < 12 && found != learnt.end(); ++n)
        twelve[n] = found->rows[n / 4][static_cast<int>(n % 4)];
    }
  }
  return out;
}

PoseSpaceData pose_space_data(const deform::PoseSpace& space, const std::vector<std::uint32_t>& vertex_of,
                              const std::vector<BoundVertex>& vertices, const std::vector<std::uint16_t>& entry_of,
                              std::size_t palette_size) {
  PoseSpaceData out;
  out.sigma = space.sigma;
  out.parents.assign(palette_size, kNoJoint);
  std::vector<std::uint32_t> joint_of(palette_size, 0);
  for (const BoundVertex& vertex : vertices)
    for (const BoundInfluence& i : vertex) {
      if (!(i.weight > 0) || space.parents[i.joint] == kNone) continue;
      out.parents[entry_of[i.joint]] = entry_of[static_cast<std::size_t>(space.parents[i.joint])];
      joint_of[entry_of[i.joint]] = i.joint;
    }
  for (const deform::PoseSpaceExample& from : space.examples) {
    PoseSpaceData::Example& e = out.examples.emplace_back();
    for (std::size_t entry = 0; entry < palette_size; ++entry)
      e.rotations.push_back(out.parents[entry] == kNoJoint ? glm::dquat(1, 0, 0, 0) : from.rotations[joint_of[entry]]);
    for (const std::uint32_t v : vertex_of) e.deltas.push_back(from.deltas[v]);
  }
  return out;
}

}  // namespace

std::vector<std::uint32_t> joints_of_deformers(const BoundDeformers& deformers, const BoundVertex& vertex) {
  std::vector<std::uint32_t> out;
  if (!deformers.multi_weights.empty()) out.push_back(deformers.root);
  if (deformers.pose_space.examples.empty()) return out;
  for (const BoundInfluence& i : vertex)
    if (i.weight > 0 && deformers.pose_space.parents[i.joint] != kNone)
      out.push_back(static_cast<std::uint32_t>(deformers.pose_space.parents[i.joint]));
  return out;
}

DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size) {
  const BoundDeformers& from = binding.deformers;
  const std::vector<BoundVertex>& vertices = binding.primitives[primitive];
  DeformerData out;
  if (!from.multi_weights.empty())
    out.multi_weight = multi_weight_data(from, from.vertex_of[primitive], vertices, entry_of);
  if (!from.pose_space.examples.empty())
    out.pose_space = pose_space_data(from.pose_space, from.vertex_of[primitive], vertices, entry_of, palette_size);
  return out;
}

}  // namespace marrow::cook
