#include "cook/skeleton/build_nodes.h"

#include "cook/scene/matrices.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

struct Place {
  std::uint32_t skeleton = 0;
  NearestJoint nearest;
};

Place place_of(std::size_t node, const BuiltScene& scene) {
  const NearestJoint& nearest = scene.nearest[node];
  return {nearest.skeleton == kNone ? 0u : static_cast<std::uint32_t>(nearest.skeleton), nearest};
}

BuiltNode build_node(const RawNode& raw, const Place& place) {
  BuiltNode node;
  node.name = raw.name;
  node.skeleton = place.skeleton;
  if (place.nearest.joint != kNone) node.joint = static_cast<std::uint16_t>(place.nearest.joint);
  node.joint_from_node = to_affine(place.nearest.joint_from_node);
  node.properties = raw.extras;
  return node;
}

}  // namespace

BuiltNodes build_nodes(const RawScene& scene, const BuiltScene& built, const std::vector<std::string>& keep,
                       Notes& notes) {
  BuiltNodes out;
  for (const std::string& glob : keep) out.kept.push_back({glob, {}});
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const RawNode& raw = scene.nodes[n];
    if (raw.name.empty() || !raw.in_scene) continue;
    bool kept = raw.kept;
    for (Kept& rule : out.kept) {
      if (!tools::fits(rule.glob, raw.name)) continue;
      rule.nodes.push_back(raw.name);
      kept = true;
    }
    if (!kept) continue;
    if (raw.dropped_extras > 0)
      notes.warnings.push_back({"/nodes/" + std::to_string(n) + "/extras", "extras-dropped",
                                std::to_string(raw.dropped_extras) +
                                    " values are left out: nulls, infinite numbers, or texts with a zero character"});
    out.nodes.push_back(build_node(raw, place_of(n, built)));
  }
  for (const Kept& rule : out.kept)
    if (rule.nodes.empty())
      notes.warnings.push_back({"/nodes", "keep-fits-nothing", "no node of the scene is called \"" + rule.glob + "\""});
  return out;
}

}  // namespace marrow::cook
