// A glTF scene with two characters, their targets, a machine, and scenery, made in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {

class SceneDocument {
 public:
  // No nodes yet.
  SceneDocument() {
    b.root["nodes"] = Json::array();
    b.root["scenes"][0]["nodes"] = Json::array();
  }

  // A node below `parent`, or at the root of the scene.
  int node(const std::string& name, int parent = -1, const std::vector<float>& translation = {0, 0, 0}) {
    const auto index = static_cast<int>(b.root["nodes"].size());
    b.root["nodes"].push_back({{"name", name}, {"translation", translation}});
    if (parent < 0) {
      b.root["scenes"][0]["nodes"].push_back(index);
    } else {
      b.root["nodes"][static_cast<std::size_t>(parent)]["children"].push_back(index);
    }
    return index;
  }

  // Four vertices hung rigidly on a node.
  void prop(int on) {
    if (prop_mesh_ < 0) {
      b.root["meshes"].push_back(
          {{"name", "prop"}, {"primitives", {{{"attributes", {{"POSITION", b.curve(4)}}}, {"indices", quad()}}}}});
      prop_mesh_ = static_cast<int>(b.root["meshes"].size()) - 1;
    }
    b.root["nodes"][static_cast<std::size_t>(on)]["mesh"] = prop_mesh_;
  }

  // A mesh of four vertices that follow these joints in turn, drawn at a node of its own. All inverse binds are the
  // identity: only that both sides do the same matters.
  int skin(const std::string& name, const std::vector<int>& joints) {
    const auto last = static_cast<std::uint8_t>(joints.size() - 1);
    const auto second = static_cast<std::uint8_t>(joints.size() > 1 ? 1 : 0);
    const int positions = b.curve(4);
    const int of = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 0, 0, 0, second, 0, 0, 0, 0, last, 0, 0, last, 0, 0, 0});
    const int weights = b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, .25F, .75F, 0, 0, 1, 0, 0, 0});
    const Json attributes = {{"POSITION", positions}, {"JOINTS_0", of}, {"WEIGHTS_0", weights}};
    b.root["meshes"].push_back(
        {{"name", name + " mesh"}, {"primitives", {{{"attributes", attributes}, {"indices", quad()}}}}});
    b.root["skins"].push_back({{"name", name}, {"joints", joints}});
    const int at = node(name + " body");
    Json& drawn = b.root["nodes"][static_cast<std::size_t>(at)];
    drawn["mesh"] = b.root["meshes"].size() - 1;
    drawn["skin"] = b.root["skins"].size() - 1;
    return at;
  }

  // A character with its armature at `x`: hips, spine and head, and arm on the spine; returns its joints.
  std::vector<int> character(const std::string& name, float x) {
    const int armature = node(name + " armature", -1, {x, 0, 0});
    const int hips = node("hips", armature, {0, 1, 0});
    const int spine = node("spine", hips, {0, 0.5F, 0});
    const int head = node("head", spine, {0, 0.25F, 0});
    const int arm = node("arm", spine, {0.25F, 0.125F, 0});
    skin(name, {hips, spine, head, arm});
    return {hips, spine, head, arm};
  }

  void clip(const std::string& name) {
    b.root["animations"].push_back({{"name", name}, {"samplers", Json::array()}, {"channels", Json::array()}});
  }
  // The last clip turns a node about Z, a little further each of `seconds`.
  void turn(int node, const std::vector<float>& seconds) {
    std::vector<float> rotations;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      const float s = i % 2 == 0 ? 0.0F : 0.28F, c = i % 2 == 0 ? 1.0F : 0.96F;
      rotations.insert(rotations.end(), {0, 0, s, c});
    }
    channel(node, "rotation", b.times(seconds), b.numbers<float>(kF32, "VEC4", 4, rotations));
  }
  // The last clip carries a node from where it is at x = 0 to x = 1 and back.
  void carry(int node, const std::vector<float>& seconds) {
    std::vector<float> places;
    for (std::size_t i = 0; i < seconds.size(); ++i)
      places.insert(places.end(), {i % 2 == 0 ? 0.0F : 1.0F, 0.125F * static_cast<float>(i), 0});
    channel(node, "translation", b.times(seconds), b.numbers<float>(kF32, "VEC3", 3, places));
  }

  // The last clip moves a node's path by these numbers, as many a key as it has.
  void keys(int node, const std::string& path, const std::vector<float>& seconds, const std::vector<float>& numbers,
            const char* interpolation = "LINEAR") {
    const bool turns = path == "rotation";
    channel(node, path.c_str(), b.times(seconds),
            b.numbers<float>(kF32, turns ? "VEC4" : "VEC3", turns ? 4 : 3, numbers));
    b.root["animations"].back()["samplers"].back()["interpolation"] = interpolation;
  }

  std::string text() { return b.text(); }
  RawScene read() { return cook::read(b); }

  Builder b;

 private:
  int quad() { return b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 1, 3, 2}); }
  void channel(int node, const char* path, int input, int output) {
    Json& animation = b.root["animations"].back();
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}});
  }

  int prop_mesh_ = -1;
};

// How much a vertex of the first primitive follows a joint.
inline double weight_of(const RawScene& scene, std::size_t vertex, std::uint32_t joint) {
  double out = 0;
  for (const RawInfluence& i : scene.meshes[0].primitives[0].influences[vertex])
    if (i.joint == joint) out += static_cast<double>(i.weight);
  return out;
}

}  // namespace marrow::cook
