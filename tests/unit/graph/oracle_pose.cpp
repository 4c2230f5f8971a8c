// What the oracle shows: rotations in double, blended as blend.h says.
#include <algorithm>
#include <cmath>

#include "unit/graph/graph_rig.h"
#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

namespace {
glm::dquat towards(const glm::dquat& to, const glm::dquat& from) {
  return glm::dot(to, from) < 0 ? -to : to;
}
// The mean; weights need not sum to 1.
Pose mean(const std::vector<std::pair<Pose, double>>& poses) {
  Pose out = poses[0].first;
  for (std::size_t b = 0; b < out.size(); ++b) {
    glm::dquat sum(0, 0, 0, 0);
    for (const auto& [pose, w] : poses) sum = sum + towards(pose[b], sum) * w;
    out[b] = glm::normalize(sum);
  }
  return out;
}

// Rotations from the root down to each bone.
Pose model_of(const Pose& local) {
  Pose out = local;
  for (std::size_t b = 0; b < out.size(); ++b)
    if (kGraphBones[b].parent >= 0) out[b] = out[static_cast<std::size_t>(kGraphBones[b].parent)] * local[b];
  return out;
}
Pose in_model(const Pose& base, const Pose& over, double weight, const std::vector<double>& mask) {
  const Pose from = model_of(base), to = model_of(over);
  Pose out = from, local = base;
  for (std::size_t b = 0; b < out.size(); ++b) {
    const double w = weight * (mask.empty() ? 1 : mask[b]);
    out[b] = glm::normalize(from[b] * (1 - w) + towards(to[b], from[b]) * w);
    const int parent = kGraphBones[b].parent;
    local[b] = parent < 0 ? out[b] : glm::conjugate(out[static_cast<std::size_t>(parent)]) * out[b];
  }
  return local;
}
}  // namespace

Pose Animator::pose(const std::function<Pose(std::size_t, double)>& leaf, const Pose& rest,
                    const Pose& reference) const {
  return shown(graph_.output, leaf, rest, reference).pose;
}

Shown Animator::shown(int node, const std::function<Pose(std::size_t, double)>& leaf, const Pose& rest,
                      const Pose& reference) const {
  const auto i = static_cast<std::size_t>(node);
  const Node& n = graph_.nodes[i];
  const NodeState& state = nodes_[i];
  if (n.kind == Kind::clip) return {leaf(n.clip, folded(clips()[n.clip], n.play, state.x)), 1};
  if (n.kind == Kind::given) return {rest, 1};
  std::vector<std::pair<Pose, double>> all;
  if (n.kind == Kind::space) {
    double rate = 1;
    const std::vector<double> w = weights(n, false, rate);
    for (std::size_t p = 0; p < w.size(); ++p) {
      if (w[p] <= 0) continue;
      if (n.in_step) {
        const std::size_t clip = graph_.nodes[static_cast<std::size_t>(n.points[p].node)].clip;
        all.emplace_back(leaf(clip, folded(clips()[clip], Play::loop, time_at(clips()[clip], state.place))), w[p]);
      } else {
        all.emplace_back(shown(n.points[p].node, leaf, rest, reference).pose, w[p]);
      }
    }
    return {mean(all), 1};
  }
  if (n.kind == Kind::machine) {
    double there = 0;
    for (const auto& [s, w] : state_weights(state)) {
      const int child = n.states[static_cast<std::size_t>(s)].node;
      if (child < 0 || w <= 0) continue;
      const Shown each = shown(child, leaf, rest, reference);
      if (each.there <= 0) continue;
      all.emplace_back(each.pose, w * each.there);
      there += w * each.there;
    }
    return all.empty() ? Shown{rest, 0} : Shown{mean(all), there};
  }
  Shown out = shown(n.base, leaf, rest, reference);
  if (layer_weight(n, state) <= 0) return out;
  const Shown over = shown(n.pose, leaf, rest, reference);
  const double weight = layer_weight(n, state) * over.there;
  if (n.in_model) return {in_model(out.pose, over.pose, weight, n.mask), out.there};
  for (std::size_t b = 0; b < out.pose.size(); ++b) {
    const double w = weight * (n.mask.empty() ? 1 : n.mask[b]);
    if (w <= 0) continue;
    glm::dquat& q = out.pose[b];
    if (n.additive) {
      glm::dquat change = over.pose[b] * glm::conjugate(reference[b]);
      if (change.w < 0) change = -change;
      q = glm::normalize(glm::dquat(1 - w, 0, 0, 0) + change * w) * q;
    } else {
      q = glm::normalize(q * (1 - w) + towards(over.pose[b], q) * w);
    }
  }
  return out;
}

}  // namespace marrow::test::oracle
