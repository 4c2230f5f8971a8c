#include "cook/clip/split_clips.h"

#include <algorithm>
#include <map>

#include "cook/skeleton/group_trees.h"

namespace marrow::cook {

std::vector<ClipPart> split_clips(const RawScene& scene, const BuiltScene& built) {
  const auto skeleton_of = [&](int node) { return built.nearest[static_cast<std::size_t>(node)].skeleton; };
  std::vector<ClipPart> out;
  for (const RawClip& clip : scene.clips) {
    std::map<int, RawClip> parts;
    float duration_s = 0;
    for (const RawChannel& channel : clip.channels) {
      // Outside the scene, as the reader has said.
      if (built.joint_of_node[static_cast<std::size_t>(channel.node)] == kNone) continue;
      parts[skeleton_of(channel.node)].channels.push_back(channel);
      duration_s = std::max(duration_s, channel.times_s.back());
    }
    const auto skeleton_of_weights = [&](const RawScalar& scalar) {
      return scalar.node == kNone ? kNone : skeleton_of(node_of_weights(scene, scalar.node));
    };
    for (const RawScalar& scalar : clip.scalars)
      if (const int skeleton = skeleton_of_weights(scalar); skeleton != kNone) parts[skeleton];
    if (parts.empty()) parts[0];
    for (const RawScalar& scalar : clip.scalars) {
      const int skeleton = skeleton_of_weights(scalar);
      parts[skeleton != kNone ? skeleton : parts.begin()->first].scalars.push_back(scalar);
      duration_s = std::max(duration_s, scalar.times_s.back());
    }
    for (auto& [skeleton, part] : parts) {
      part.name = clip.name;
      part.additive = clip.additive;
      out.push_back({static_cast<std::uint32_t>(skeleton), static_cast<std::size_t>(&clip - scene.clips.data()),
                     std::move(part), duration_s});
    }
  }
  return out;
}

}  // namespace marrow::cook
