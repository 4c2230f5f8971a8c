#include "road/scenes/made_scene.h"

#include <algorithm>

#include "unit/cook/gltf/document.h"

namespace marrow::test {
namespace {

using cook::Builder;
using cook::Json;
using cook::kF32;
using cook::kU16;
using cook::kU8;

Json node_json(const MadeNode& node) {
  Json out = {
      {"name", node.name}, {"translation", node.translation}, {"rotation", node.rotation}, {"scale", node.scale}};
  if (node.kind == MadeNodeKind::camera) out["camera"] = 0;
  if (node.kind == MadeNodeKind::light) out["extensions"]["KHR_lights_punctual"]["light"] = 0;
  return out;
}

void add_nodes(const std::vector<MadeNode>& nodes, Builder& b) {
  b.root["nodes"] = Json::array();
  b.root["scenes"][0]["nodes"] = Json::array();
  for (const MadeNode& node : nodes) {
    b.root["nodes"].push_back(node_json(node));
    if (node.kind == MadeNodeKind::camera)
      b.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    if (node.kind != MadeNodeKind::light) continue;
    b.root["extensionsUsed"] = {"KHR_lights_punctual"};
    b.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent < 0)
      b.root["scenes"][0]["nodes"].push_back(i);
    else
      b.root["nodes"][static_cast<std::size_t>(nodes[i].parent)]["children"].push_back(i);
  }
}

void add_mesh(const MadeMesh& mesh, Builder& b) {
  Json attributes = {{"POSITION", b.positions(mesh.positions)}};
  Json& drawn = b.root["nodes"][static_cast<std::size_t>(mesh.node)];
  if (!mesh.joints.empty()) {
    attributes["JOINTS_0"] = b.numbers<std::uint8_t>(kU8, "VEC4", 4, mesh.of);
    attributes["WEIGHTS_0"] = b.numbers<float>(kF32, "VEC4", 4, mesh.weights);
    b.root["skins"].push_back(
        {{"joints", mesh.joints}, {"inverseBindMatrices", b.numbers<float>(kF32, "MAT4", 16, mesh.inverse_bind)}});
    drawn["skin"] = b.root["skins"].size() - 1;
  }
  std::vector<std::uint16_t> indices;
  for (std::size_t v = 0; v + 2 < mesh.positions.size() / 3; ++v)
    for (std::size_t corner = 0; corner < 3; ++corner) indices.push_back(static_cast<std::uint16_t>(v + corner));
  Json primitive = {{"attributes", attributes}, {"indices", b.numbers<std::uint16_t>(kU16, "SCALAR", 1, indices)}};
  for (const std::vector<float>& target : mesh.targets)
    primitive["targets"].push_back({{"POSITION", b.positions(target)}});
  b.root["meshes"].push_back({{"primitives", {primitive}}});
  drawn["mesh"] = b.root["meshes"].size() - 1;
  if (!mesh.target_weights.empty()) drawn["weights"] = mesh.target_weights;
}

void add_clip(const MadeClip& clip, Builder& b) {
  Json animation = {{"name", clip.name}, {"samplers", Json::array()}, {"channels", Json::array()}};
  for (const MadeChannel& channel : clip.channels) {
    const int input = b.times(channel.times_s);
    const bool four = channel.path == "rotation", one = channel.path == "weights";
    const int output = b.numbers<float>(kF32,
                                        four  ? "VEC4"
                                        : one ? "SCALAR"
                                              : "VEC3",
                                        four  ? 4
                                        : one ? 1
                                              : 3,
                                        channel.values);
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", channel.node}, {"path", channel.path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", channel.interpolation}});
  }
  b.root["animations"].push_back(std::move(animation));
}

// The pack's file has a joint turned that a clip of it leaves alone: it is seen as it is there.
MadeClip held(MadeClip clip, const MadeScene& scene) {
  const bool moved = std::ranges::any_of(clip.channels, [&](const MadeChannel& channel) {
    return channel.node == scene.turned && channel.path == "rotation";
  });
  if (scene.turned < 0 || moved) return clip;
  MadeChannel hold{scene.turned, "rotation", "LINEAR", {0}, {}};
  for (const double q : scene.turned_to) hold.values.push_back(static_cast<float>(q));
  clip.channels.push_back(hold);
  return clip;
}

}  // namespace

std::string text_of(const MadeScene& scene, bool with_pack) {
  Builder b;
  add_nodes(scene.nodes, b);
  for (const MadeMesh& mesh : scene.meshes) add_mesh(mesh, b);
  for (const MadeClip& clip : scene.clips)
    if (with_pack || !clip.of_pack) add_clip(clip.of_pack ? held(clip, scene) : clip, b);
  return b.text();
}

std::string pack_text_of(const MadeScene& scene) {
  MadeScene other;
  const auto count = static_cast<int>(scene.nodes.size());
  const auto index = [&](int node) { return count - 1 - node; };  // the other way round
  const double unit = scene.pack_unit;
  for (int i = count; i-- > 0;) {
    MadeNode node = scene.nodes[static_cast<std::size_t>(i)];
    node.parent = node.parent < 0 ? count : index(node.parent);
    for (double& t : node.translation) t *= unit;
    if (i == scene.turned) node.rotation = scene.turned_to;
    node.kind = MadeNodeKind::transform;
    other.nodes.push_back(node);
  }
  other.nodes.push_back({"root of the pack", -1, {0, 3, 0}, {0.6, 0, 0, 0.8}, {1 / unit, 1 / unit, 1 / unit}, {}});
  Builder b;
  add_nodes(other.nodes, b);
  for (const MadeClip& clip : scene.clips) {
    if (!clip.of_pack) continue;
    MadeClip there = clip;
    for (MadeChannel& channel : there.channels) {
      channel.node = index(channel.node);
      if (channel.path == "translation")
        for (float& value : channel.values) value = static_cast<float>(static_cast<double>(value) * unit);
    }
    add_clip(there, b);
  }
  return b.text();
}

}  // namespace marrow::test
