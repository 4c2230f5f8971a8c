#include "cook/prepare/idle_motion.h"

#include <algorithm>

#include "common/distinct.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {

std::vector<char> carrying_nodes(const RawScene& scene, const std::vector<std::string>& keep) {
  std::vector<char> out(scene.nodes.size(), 0);
  const auto mark = [&](int node) {
    for (; node != kNone && out[to_index(node)] == 0; node = scene.nodes[to_index(node)].parent)
      out[to_index(node)] = 1;
  };
  for (const RawInstance& instance : scene.instances) mark(instance.node);
  for (const RawCollider& collider : scene.colliders) mark(collider.node);
  for (const RawSkin* const skin : skins_in_use(scene))
    for (const int joint : skin->joints) mark(joint);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const RawNode& node = scene.nodes[n];
    if (node.kept || node.moved_by_game || node.limit || (scene.instances.empty() && !node.is_view) ||
        std::ranges::any_of(keep, [&](const std::string& glob) { return tools::fits(glob, node.name); }))
      mark(static_cast<int>(n));
  }
  return out;
}

RawScene without_idle_motion(RawScene scene, const std::vector<std::string>& keep, Notes& notes) {
  const std::vector<char> carries = carrying_nodes(scene, keep);
  std::vector<int> idle;
  for (RawClip& clip : scene.clips)
    std::erase_if(clip.channels, [&](const RawChannel& channel) {
      const RawNode& node = scene.nodes[to_index(channel.node)];
      if (carries[to_index(channel.node)] != 0 || !node.in_scene) return false;
      idle.push_back(channel.node);
      return true;
    });
  if (idle.empty()) return scene;
  tools::make_distinct(idle);
  std::vector<std::string> names;
  for (const int node : idle) {
    const std::string& name = scene.nodes[to_index(node)].name;
    names.push_back(name.empty() ? "nodes[" + std::to_string(node) + ']' : '"' + name + '"');
  }
  notes.warnings.push_back(
      {"/nodes/" + std::to_string(idle.front()), "motion-of-nothing",
       "clips move " + tools::listed(names) +
           ": nothing is drawn or kept there or below, so that is left out; --keep NAME keeps it"});
  return scene;
}

}  // namespace marrow::cook
