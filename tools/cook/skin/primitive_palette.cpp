#include "cook/skin/primitive_palette.h"

#include <algorithm>

#include "common/distinct.h"
#include "common/failure.h"
#include "cook/scene/matrices.h"
#include "cook/skin/bound_deformers.h"

namespace marrow::cook {

std::vector<std::uint32_t> palette_needs(const SkinBinding& binding, std::size_t joint_count,
                                         const BoundVertex& vertex) {
  std::vector<std::uint32_t> out = joints_of_deformers(binding.deformers, vertex);
  for (const BoundInfluence& i : vertex) {
    out.push_back(i.joint);
    if (i.joint < joint_count) continue;
    const deform::Helper& helper = binding.helpers[i.joint - joint_count];
    out.insert(out.end(), {helper.first, helper.second});
  }
  tools::make_distinct(out);
  return out;
}

Palette make_palette(const RawSkin& skin, const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                     const std::vector<int>& joint_of_node, std::vector<std::uint16_t>& entry_of) {
  const std::size_t joints = skin.joints.size();
  entry_of.assign(joints + binding.helpers.size(), 0);
  for (const BoundVertex& vertex : vertices)
    for (const std::uint32_t needed : palette_needs(binding, joints, vertex)) entry_of[needed] = 1;
  if (std::ranges::count(entry_of, 1) > static_cast<std::ptrdiff_t>(kMaxJoints))
    throw tools::Failure(tools::Exit::unsupported, "", "", "too-many-joints",
                         "a primitive follows at most 32767 joints and helpers");
  Palette out;
  for (std::size_t j = 0; j < joints; ++j) {
    if (entry_of[j] == 0) continue;
    entry_of[j] = static_cast<std::uint16_t>(out.joints.size());
    out.joints.push_back(static_cast<std::uint16_t>(joint_of_node[static_cast<std::size_t>(skin.joints[j])]));
    out.inverse_bind.push_back(to_affine(skin.inverse_bind[j]));
  }
  for (std::size_t h = 0; h < binding.helpers.size(); ++h) {
    if (entry_of[joints + h] == 0) continue;
    const deform::Helper& helper = binding.helpers[h];
    entry_of[joints + h] = static_cast<std::uint16_t>(out.size());
    out.helpers.push_back({entry_of[helper.first], entry_of[helper.second], static_cast<float>(helper.share)});
    if (helper.by_dual_quaternions) continue;
    const glm::dvec4 centre = skin.inverse_bind[helper.second] * glm::dvec4(helper.centre, 1);
    for (int c = 0; c < 3; ++c) out.helper_centres.push_back(static_cast<float>(centre[c]));
  }
  return out;
}

Palette some_of(const Palette& whole, const std::vector<std::uint16_t>& entries) {
  const auto place_of = [&](std::uint16_t entry) {
    return static_cast<std::uint16_t>(std::ranges::lower_bound(entries, entry) - entries.begin());
  };
  Palette out;
  for (const std::uint16_t entry : entries) {
    if (entry < whole.joints.size()) {
      out.joints.push_back(whole.joints[entry]);
      out.inverse_bind.push_back(whole.inverse_bind[entry]);
    } else {
      const std::size_t h = entry - whole.joints.size();
      const Helper& helper = whole.helpers[h];
      out.helpers.push_back({place_of(helper.first), place_of(helper.second), helper.share});
      for (std::size_t i = 3 * h; i < 3 * h + 3 && i < whole.helper_centres.size(); ++i)
        out.helper_centres.push_back(whole.helper_centres[i]);
    }
  }
  return out;
}

std::vector<Binding> bind_vertices(const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                                   const std::vector<std::uint16_t>& entry_of) {
  std::vector<Binding> out;
  for (const BoundVertex& vertex : vertices) {
    Binding b;
    for (const BoundInfluence& i : vertex) {
      b.set.push_back(entry_of[i.joint]);
      b.weights.push_back(i.weight);
      if (binding.residual_step_m > 0) b.residual.push_back(i.residual);
    }
    out.push_back(std::move(b));
  }
  return out;
}

}  // namespace marrow::cook
