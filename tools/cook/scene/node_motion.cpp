#include "cook/scene/node_motion.h"

#include <algorithm>

#include "cook/scene/matrices.h"
#include "marrow/curve.h"

namespace marrow::cook {
namespace {

CurveKind kind_of(RawInterpolation interpolation) {
  return interpolation == RawInterpolation::step     ? CurveKind::step
         : interpolation == RawInterpolation::linear ? CurveKind::linear
                                                     : CurveKind::hermite;
}

}  // namespace

glm::dvec4 value_at(const RawChannel& channel, float time_s) {
  static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
  Curve curve;
  curve.kind = kind_of(channel.interpolation);
  curve.rotation = channel.path == RawPath::rotation;
  curve.components = 4;
  curve.times_s = {channel.times_s.data(), channel.times_s.size()};
  curve.values = {&channel.values.front().x, 4 * channel.values.size()};
  float out[4] = {0, 0, 0, 1};
  static_cast<void>(evaluate_curve(curve, time_s, out));  // a curve and a time that are whole
  return {out[0], out[1], out[2], out[3]};
}

float value_at(const RawScalar& scalar, float time_s) {
  Curve curve;
  curve.kind = kind_of(scalar.interpolation);
  curve.times_s = {scalar.times_s.data(), scalar.times_s.size()};
  curve.values = {scalar.values.data(), scalar.values.size()};
  float out[1] = {scalar.rest};
  static_cast<void>(evaluate_curve(curve, time_s, out));
  return out[0];
}

NodeMotion::NodeMotion(const RawScene& scene, const RawClip& clip, const std::vector<int>& nodes) {
  constexpr std::size_t kUnknown = ~std::size_t{0};
  std::vector<std::size_t> step_of(scene.nodes.size(), kUnknown);
  std::vector<int> way;
  for (const int asked : nodes) {
    for (int n = asked; n != kNone && step_of[to_index(n)] == kUnknown; n = scene.nodes[to_index(n)].parent)
      way.push_back(n);
    for (; !way.empty(); way.pop_back()) {
      const RawNode& node = scene.nodes[to_index(way.back())];
      step_of[to_index(way.back())] = steps_.size();
      steps_.push_back({&node, node.parent == kNone ? steps_.size() : step_of[to_index(node.parent)], {}});
    }
    asked_.push_back(step_of[to_index(asked)]);
  }
  bool moves = false;
  for (const RawChannel& channel : clip.channels) {
    const std::size_t step = step_of[to_index(channel.node)];
    if (step == kUnknown) continue;
    steps_[step].paths[static_cast<int>(channel.path)] = &channel;
    first_s_ = moves ? std::min(first_s_, channel.times_s.front()) : channel.times_s.front();
    last_s_ = std::max(last_s_, channel.times_s.back());
    moves = true;
  }
}

std::vector<glm::dmat4> NodeMotion::at(float time_s) const {
  std::vector<glm::dmat4> all;
  for (const Step& step : steps_) {
    glm::dvec3 translation = step.node->translation, scale = step.node->scale;
    glm::dquat rotation = step.node->rotation;
    if (const RawChannel* const c = step.paths[static_cast<int>(RawPath::translation)])
      translation = glm::dvec3(value_at(*c, time_s));
    if (const RawChannel* const c = step.paths[static_cast<int>(RawPath::rotation)]) {
      const glm::dvec4 q = value_at(*c, time_s);
      rotation = glm::dquat(q.w, q.x, q.y, q.z);
    }
    if (const RawChannel* const c = step.paths[static_cast<int>(RawPath::scale)])
      scale = glm::dvec3(value_at(*c, time_s));
    const glm::dmat4 local = local_matrix(translation, rotation, scale);
    all.push_back(step.above == all.size() ? local : all[step.above] * local);
  }
  std::vector<glm::dmat4> out;
  for (const std::size_t step : asked_) out.push_back(all[step]);
  return out;
}

}  // namespace marrow::cook
