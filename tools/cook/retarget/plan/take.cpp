#include "cook/retarget/plan/take.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "common/distinct.h"
#include "cook/scene/matrices.h"
#include "cook/scene/node_motion.h"
#include "cook/skeleton/build_skeletons.h"

namespace marrow::cook {
namespace {

constexpr double kWidest = 1.0 / 24;     // between frames, in seconds
constexpr double kMostPoses = 1u << 22;  // of joints, in a clip whose frames are made up
constexpr float kSame = 1e-5F;           // times so near are one frame's

std::vector<float> times_of_keys(const RawClip& clip) {
  std::vector<float> all, out;
  const std::vector<float>* last = nullptr;
  for (const RawChannel& channel : clip.channels) {
    if (last != nullptr && *last == channel.times_s) continue;
    last = &channel.times_s;
    all.insert(all.end(), last->begin(), last->end());
  }
  tools::make_distinct(all);
  for (const float time_s : all)
    if (out.empty() || time_s > out.back() + kSame) out.push_back(time_s);
  return out;
}

std::vector<float> with_more(const std::vector<float>& times_s, std::size_t joints) {
  const double length = double{times_s.back()} - double{times_s.front()};
  const double widest = std::max(kWidest, length * static_cast<double>(joints) / kMostPoses) * 1.001;
  std::vector<float> out = {times_s[0]};
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double from = times_s[i - 1], gap = double{times_s[i]} - from;
    const auto parts = static_cast<std::size_t>(std::ceil(gap / widest));
    for (std::size_t part = 1; part < parts; ++part) {
      const auto time_s = static_cast<float>(from + gap * static_cast<double>(part) / static_cast<double>(parts));
      if (time_s > out.back() && time_s < times_s[i]) out.push_back(time_s);
    }
    out.push_back(times_s[i]);
  }
  return out;
}

glm::dquat unit(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 0 ? q / length : glm::dquat(1, 0, 0, 0);
}

}  // namespace

Take::Take(const RawScene& scene)
    : scene_(&scene),
      order_(parents_first(scene)),
      mirrored_(scene.nodes.size(), 0),
      channels_(scene.nodes.size()),
      matrices_(scene.nodes.size()),
      turns_(scene.nodes.size(), glm::dquat(1, 0, 0, 0)),
      places_(scene.nodes.size()) {
  for (const std::size_t n : order_) {
    const RawNode& node = scene.nodes[n];
    const bool is_above = node.parent != kNone && mirrored_[to_index(node.parent)] != 0;
    const bool is_own = (node.scale.x < 0) != ((node.scale.y < 0) != (node.scale.z < 0));
    mirrored_[n] = is_above != is_own ? 1 : 0;
  }
  pose_at(nullptr);
  rest_ = places_;
  rest_turns_ = turns_;
}

void Take::open(const RawClip& clip, std::size_t joints) {
  clip_ = &clip;
  std::ranges::fill(channels_, Channels{});
  for (const RawChannel& channel : clip.channels)
    channels_[to_index(channel.node)].paths[static_cast<int>(channel.path)] = &channel;
  times_s_ = times_of_keys(clip);
  if (!times_s_.empty() && !scene_->is_capture) times_s_ = with_more(times_s_, joints);
}

std::vector<char> Take::moved_nodes() const {
  std::vector<char> out(scene_->nodes.size(), 0);
  for (const RawChannel& channel : clip_->channels) {
    const auto elsewhere = [&](const glm::vec4& place) { return place != channel.values[0]; };
    if (channel.path == RawPath::translation && std::ranges::any_of(channel.values, elsewhere))
      out[to_index(channel.node)] = 1;
  }
  for (const std::size_t n : order_)
    if (const int parent = scene_->nodes[n].parent; parent != kNone && out[to_index(parent)] != 0) out[n] = 1;
  return out;
}

void Take::pose(std::size_t frame) {
  pose_at(&times_s_[frame]);
}

void Take::pose_at(const float* time_s) {
  for (const std::size_t n : order_) {
    const RawNode& node = scene_->nodes[n];
    glm::dvec3 translation = node.translation, scale = node.scale;
    glm::dquat rotation = node.rotation;
    if (time_s != nullptr) {
      const auto& [move, turn, stretch] = channels_[n].paths;
      if (move != nullptr) translation = glm::dvec3(value_at(*move, *time_s));
      if (stretch != nullptr) scale = glm::dvec3(value_at(*stretch, *time_s));
      if (turn != nullptr) {
        const glm::dvec4 q = value_at(*turn, *time_s);
        rotation = glm::dquat(q.w, q.x, q.y, q.z);
      }
    }
    rotation = unit(rotation);
    const glm::dmat4 local = local_matrix(translation, rotation, scale);
    if (node.parent == kNone) {
      matrices_[n] = local;
      turns_[n] = rotation;
    } else {
      const std::size_t up = to_index(node.parent);
      matrices_[n] = matrices_[up] * local;
      turns_[n] = turns_[up] * (mirrored_[up] != 0 ? in_mirrored(rotation) : rotation);
    }
    places_[n] = glm::dvec3(matrices_[n][3]);
  }
}

glm::dvec3 Take::mixed(const std::vector<glm::dvec3>& places, const Counterpart& at) const {
  const glm::dvec3& place = places[to_index(at.node)];
  return at.other == kNone ? place : glm::mix(place, places[to_index(at.other)], at.share);
}

glm::dquat Take::turn(const Counterpart& at) const {
  const auto since_rest = [&](int node) {
    return turns_[to_index(node)] * glm::conjugate(rest_turns_[to_index(node)]);
  };
  const glm::dquat own = since_rest(at.node);
  if (at.other == kNone) return own;
  const glm::dquat other = since_rest(at.other);
  return unit(own * (1 - at.share) + (glm::dot(own, other) < 0 ? -other : other) * at.share);
}

}  // namespace marrow::cook
