// A character with five joints a segment: a tube along a spine, and two legs of two joints on each joint of it.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "cook/scene/raw.h"

namespace marrow::test {

class Millipede {
 public:
  static constexpr std::uint32_t kSides = 8;  // of a ring of the body; of a leg's three

  explicit Millipede(std::uint32_t segments) {
    scene.source = "millipede.gltf";
    scene.skins.emplace_back();
    scene.skins[0].name = "millipede";
    for (std::uint32_t s = 0; s < segments; ++s) add_joints(s);
    body_.pointer = "/meshes/0/primitives/0";
    for (std::uint32_t ring = 0; ring < 2 * segments; ++ring) add_body_ring(ring, segments);
    for (std::uint32_t s = 0; s < segments; ++s)
      for (std::uint32_t side = 0; side < 2; ++side) add_leg(s, side);
    scene.meshes.push_back({"millipede", {}, {body_}});
    cook::RawNode carrier;
    carrier.name = "drawn";
    scene.nodes.push_back(carrier);
    scene.instances.push_back({static_cast<int>(scene.nodes.size()) - 1, 0, 0, {}, cook::kNone});
    scene.clips.push_back({"walk", {}, {}});
    for (std::size_t j = 0; j < scene.skins[0].joints.size(); ++j) turn(static_cast<int>(j));
  }

  // One target moves every vertex, the other those of the first segments alone.
  void add_targets() {
    scene.meshes[0].weights = {{"swell", "drawn.swell", 0.5f}, {"nod", "drawn.nod", 0.75f}};
    scene.instances[0].weights = scene.meshes[0].weights;
    cook::RawPrimitive& p = scene.meshes[0].primitives[0];
    p.targets.resize(2);
    for (const glm::vec3& v : p.positions) {
      p.targets[0].positions.emplace_back(0, v.y * 0.25f, v.z * 0.125f);
      p.targets[1].positions.emplace_back(0, v.x < 0.3f ? 0.05f : 0.0f, 0);
    }
  }

  cook::RawScene scene;

 private:
  static float along(std::uint32_t segment) { return 0.1f * static_cast<float>(segment); }

  int add_joint(const std::string& name, int parent, const glm::dvec3& place, const glm::dvec3& parents_place) {
    cook::RawNode node;
    node.name = name;
    node.parent = parent;
    node.translation = place - parents_place;
    scene.nodes.push_back(node);
    scene.skins[0].joints.push_back(static_cast<int>(scene.nodes.size()) - 1);
    glm::dmat4 inverse_bind(1.0);
    inverse_bind[3] = glm::dvec4(-place, 1);
    scene.skins[0].inverse_bind.push_back(inverse_bind);
    return static_cast<int>(scene.nodes.size()) - 1;
  }

  void add_joints(std::uint32_t s) {
    const auto x = static_cast<double>(along(s));
    const std::string number = std::to_string(s);
    const glm::dvec3 spine(x, 0, 0), before(static_cast<double>(along(s == 0 ? 0 : s - 1)), 0, 0);
    const int joint = add_joint("spine" + number, s == 0 ? cook::kNone : 5 * static_cast<int>(s) - 5, spine,
                                s == 0 ? glm::dvec3(0) : before);
    for (const double z : {0.1, -0.1}) {
      const std::string end = z > 0 ? ".l" : ".r";
      const glm::dvec3 hip(x, 0, z), foot(x, -0.1, 2 * z);
      add_joint("foot" + number + end, add_joint("hip" + number + end, joint, hip, spine), foot, hip);
    }
  }

  std::uint32_t add_vertex(const glm::vec3& position, const glm::vec3& normal,
                           std::vector<cook::RawInfluence> follows) {
    body_.positions.push_back(position);
    body_.normals.push_back(normal);
    body_.uvs.emplace_back(position.x, position.z);
    body_.influences.push_back(std::move(follows));
    return static_cast<std::uint32_t>(body_.positions.size()) - 1;
  }

  // Between ring `first` and the one of as many vertices at `second`.
  void join(std::uint32_t first, std::uint32_t second, std::uint32_t sides) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % sides, c = second + i, d = second + (i + 1) % sides;
      body_.indices.insert(body_.indices.end(), {a, b, c, b, d, c});
    }
  }

  void add_body_ring(std::uint32_t ring, std::uint32_t segments) {
    const std::uint32_t s = ring / 2, next = std::min(s + 1, segments - 1);
    const float share = ring % 2 == 0 || next == s ? 0.0f : 0.5f;
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const float angle = 6.2831853f * static_cast<float>(i) / kSides;
      const glm::vec3 out(0, std::cos(angle), std::sin(angle));
      std::vector<cook::RawInfluence> follows = {{5 * s, 1 - share}};
      if (share > 0) follows.push_back({5 * next, share});
      add_vertex(out * 0.08f + glm::vec3(0.05f * static_cast<float>(ring), 0, 0), out, std::move(follows));
    }
    if (ring > 0) join(kSides * (ring - 1), kSides * ring, kSides);
  }

  void add_leg(std::uint32_t s, std::uint32_t side) {
    const std::uint32_t hip = 5 * s + 1 + 2 * side;
    const float z = side == 0 ? 0.1f : -0.1f, x = along(s);
    const std::array<std::vector<cook::RawInfluence>, 3> follows = {
        {{{5 * s, 0.5f}, {hip, 0.5f}}, {{hip, 0.5f}, {hip + 1, 0.5f}}, {{hip + 1, 1.0f}}}};
    std::uint32_t before = 0;
    for (std::uint32_t ring = 0; ring < 3; ++ring) {
      const auto far = static_cast<float>(ring);
      const auto first = static_cast<std::uint32_t>(body_.positions.size());
      for (std::uint32_t i = 0; i < 3; ++i) {
        const float angle = 2.0943951f * static_cast<float>(i);
        const glm::vec3 out(std::cos(angle), 0, std::sin(angle));
        add_vertex(out * 0.02f + glm::vec3(x, -0.05f * far, z * (1 + 0.5f * far)), out, follows[ring]);
      }
      // The first stands on the body.
      if (ring == 0)
        body_.indices.insert(body_.indices.end(), {first, kSides * 2 * s + (side == 0 ? 2 : 6), first + 1});
      if (ring > 0) join(before, first, 3);
      before = first;
    }
  }

  void turn(int node) {
    cook::RawChannel channel;
    channel.node = node;
    channel.path = cook::RawPath::rotation;
    channel.times_s = {0, 1};
    const float angle = 0.01f * static_cast<float>(node * 5 % 17 - 8) * (node % 5 == 0 ? 1.0f : 6.0f);
    channel.values = {{0, 0, 0, 1}, {0, std::sin(angle), node % 2 == 0 ? std::sin(angle) : 0, 0}};
    glm::vec4& q = channel.values[1];
    q.w = std::sqrt(1 - q.y * q.y - q.z * q.z);
    scene.clips[0].channels.push_back(channel);
  }

  cook::RawPrimitive body_;
};

}  // namespace marrow::test
