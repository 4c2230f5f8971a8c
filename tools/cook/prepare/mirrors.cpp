#include "cook/prepare/mirrors.h"

#include <cstdint>
#include <utility>

namespace marrow::cook {
namespace {

// Half a turn about an axis, or none: scale by the factors, then turn.
struct HalfTurn {
  glm::vec3 factors{1};
  glm::quat turn{1, 0, 0, 0};
};

// signs: of a scale's axes, 0 where it has none.
HalfTurn half_turn_for(glm::vec3 signs) {
  float product = 1;
  for (int i = 0; i < 3; ++i)
    if (signs[i] != 0) product *= signs[i];
  for (int i = 0; i < 3; ++i) {  // what has no sign has whichever is needed
    if (signs[i] != 0) continue;
    signs[i] = product;
    product = 1;
  }
  HalfTurn out;
  out.factors = glm::vec3(signs.x * product, signs.y, signs.z);
  if (out.factors.y > 0 && out.factors.z > 0) return out;
  const auto about = [&](int axis) { return out.factors[axis] > 0 ? 1.0f : 0.0f; };
  out.turn = glm::quat(0.0f, about(0), about(1), about(2));
  return out;
}

float sign_of(double x) {
  return x > 0 ? 1.0f : x < 0 ? -1.0f : 0.0f;
}

HalfTurn of_node(const RawNode& node) {
  return half_turn_for({sign_of(node.scale.x), sign_of(node.scale.y), sign_of(node.scale.z)});
}

// By the first value of each axis that has a sign.
HalfTurn of_scale(const RawChannel& channel) {
  const std::size_t step = channel.values.size() / channel.times_s.size();
  glm::vec3 signs(0);
  for (std::size_t i = step / 2; i < channel.values.size(); i += step)
    for (int c = 0; c < 3; ++c)
      if (signs[c] == 0) signs[c] = sign_of(static_cast<double>(channel.values[i][c]));
  return half_turn_for(signs);
}

bool turns(const HalfTurn& half) {
  return half.turn.w == 0;
}

glm::vec4 turned(const glm::vec4& key, const HalfTurn& half) {
  const glm::quat q = glm::quat(key.w, key.x, key.y, key.z) * half.turn;
  return {q.x, q.y, q.z, q.w};
}

void turn_node(const HalfTurn& half, RawNode& node) {
  if (!turns(half)) return;
  node.scale *= glm::dvec3(half.factors);
  node.rotation = node.rotation * glm::dquat(half.turn);
  if (!node.limit) return;
  // Its angles are about axes that turn along.
  LimitDescription& limit = node.limit->description;
  for (int i = 0; i < 3; ++i) {
    limit.axis[i] *= half.factors[i];
    limit.across[i] *= half.factors[i];
  }
  const glm::vec4 zero = turned({limit.zero[0], limit.zero[1], limit.zero[2], limit.zero[3]}, half);
  for (int i = 0; i < 4; ++i) limit.zero[i] = zero[i];
}

// What a clip moves of a node; null: at rest.
struct Moved {
  RawChannel *rotation = nullptr, *scale = nullptr;
};

// half: the node's own.
void turn_clip(const std::vector<RawNode>& nodes, const std::vector<HalfTurn>& half, RawClip& clip) {
  std::vector<std::pair<int, Moved>> moved;
  std::vector<std::size_t> at(nodes.size(), SIZE_MAX);
  for (RawChannel& channel : clip.channels) {
    if (channel.path == RawPath::translation) continue;
    std::size_t& i = at[to_index(channel.node)];
    if (i == SIZE_MAX) {
      i = moved.size();
      moved.push_back({channel.node, {}});
    }
    (channel.path == RawPath::rotation ? moved[i].second.rotation : moved[i].second.scale) = &channel;
  }
  std::vector<RawChannel> more;
  for (const auto& [node, of] : moved) {
    const HalfTurn &rest = half[to_index(node)], own = of.scale != nullptr ? of_scale(*of.scale) : rest;
    if (of.scale != nullptr && turns(own))
      for (glm::vec4& key : of.scale->values)
        for (int i = 0; i < 3; ++i) key[i] *= own.factors[i];
    if (of.rotation != nullptr && turns(own))
      for (glm::vec4& key : of.rotation->values) key = turned(key, own);
    if (of.rotation != nullptr || own.turn == rest.turn) continue;
    // It stays as it rests, which is another rotation now.
    const glm::dquat q = nodes[to_index(node)].rotation * glm::dquat(own.turn);
    RawChannel still{node, RawPath::rotation, RawInterpolation::linear, {of.scale->times_s.front()}, {}};
    still.values.emplace_back(q.x, q.y, q.z, q.w);
    more.push_back(std::move(still));
  }
  for (RawChannel& channel : more) clip.channels.push_back(std::move(channel));
}

// Whether a node may become a joint: what hangs at the end of all and never moves does not.
std::vector<bool> may_be_joints(const RawScene& scene) {
  std::vector<bool> out;
  for (const RawNode& node : scene.nodes) out.push_back(node.moved_by_game);
  for (const RawNode& node : scene.nodes)
    if (node.parent != kNone) out[to_index(node.parent)] = true;
  for (const RawSkin& skin : scene.skins)
    for (const int joint : skin.joints) out[to_index(joint)] = true;
  for (const RawClip& clip : scene.clips)
    for (const RawChannel& channel : clip.channels) out[to_index(channel.node)] = true;
  return out;
}

}  // namespace

RawScene with_one_form_of_mirrors(RawScene scene) {
  const std::vector<bool> may_be_joint = may_be_joints(scene);
  std::vector<HalfTurn> half;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    half.push_back(may_be_joint[n] ? of_node(scene.nodes[n]) : HalfTurn{});
  for (RawClip& clip : scene.clips) turn_clip(scene.nodes, half, clip);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) turn_node(half[n], scene.nodes[n]);
  return scene;
}

}  // namespace marrow::cook
