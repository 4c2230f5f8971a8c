#include "behave/shown.h"

#include "common/check_status.h"
#include "graph/graph_step.h"

namespace marrow::tools {
namespace {

class ShownFinder {
 public:
  explicit ShownFinder(const Animator& a)
      : step_{*a.binding, a.binding->graph, a.state, *a.scratch, 0},
        weights_(step_.g.nodes.size, 0.0f),
        times_(step_.g.nodes.size, -1.0f) {}

  std::vector<ShownNode> find() {
    std::vector<ShownNode> out;
    weights_[0] = 1;
    // Nodes stand before those whose poses they take.
    for (std::uint32_t n = 0; n < weights_.size(); ++n) {
      if (!(weights_[n] > 0)) continue;
      const GraphNode& node = step_.g.nodes[n];
      ShownNode shown{n, weights_[n]};
      if (node.kind == GraphNodeKind::clip) {
        shown.is_clip = true;
        shown.animation = &step_.b.clips[node.record];
        shown.time_s = times_[n] >= 0 ? times_[n] : clip_time(playback_of(step_, n, nullptr));
      } else if (node.kind == GraphNodeKind::space) {
        divide_space(n, step_.g.spaces[node.record]);
      } else if (node.kind == GraphNodeKind::machine) {
        divide_machine(n, step_.g.machines[node.record]);
      } else if (node.kind == GraphNodeKind::layer) {
        divide_layer(n, step_.g.layers[node.record]);
      }
      out.push_back(shown);
    }
    return out;
  }

 private:
  void divide_space(std::uint32_t n, const GraphSpace& space) {
    float at[2] = {}, rate = 1;
    for (int i = 0; i < 2; ++i)
      if (space.by[i] != kNoIndex) at[i] = step_.parameter(space.by[i]).value;
    std::vector<float> weights(space.point_count);
    check(weigh_points(step_.b, space, at, weights.data(), rate));
    const Phase phase{step_.own<SpaceState>(n).share, step_.own<SpaceState>(n).segment, 0};
    for (std::uint32_t i = 0; i < space.point_count; ++i) {
      const std::uint32_t below = step_.g.points[space.first_point + i].node;
      weights_[below] += weights_[n] * weights[i];
      if ((space.flags & kSpaceInStep) == 0 || !(weights[i] > 0)) continue;
      Playback was, now;
      check(follow_phase(step_.b.clips[step_.g.nodes[below].record].motion, phase, phase, was, now));
      times_[below] = clip_time(now);
    }
  }

  // What a machine's states have, one a state of its chain; 0 where one shows nothing.
  std::vector<float> states_of(std::uint32_t n, const GraphMachine& machine, std::vector<std::uint32_t>& nodes) {
    const auto& state = step_.own<MachineState>(n);
    float weights[kMaxFading];
    weigh_chain(state, weights);
    std::vector<float> out;
    for (std::uint32_t i = 0; i < state.count; ++i) {
      nodes.push_back(step_.g.states[machine.first_state + state.chain[i]].node);
      out.push_back(nodes.back() == kNoIndex ? 0.0f : weights[i]);
    }
    return out;
  }
  void divide_machine(std::uint32_t n, const GraphMachine& machine) {
    std::vector<std::uint32_t> nodes;
    const std::vector<float> weights = states_of(n, machine, nodes);
    float sum = 0;
    for (const float weight : weights) sum += weight;
    for (std::size_t i = 0; i < nodes.size() && sum > 0; ++i)
      if (nodes[i] != kNoIndex) weights_[nodes[i]] += weights_[n] * weights[i] / sum;
  }
  float presence_of(std::uint32_t n) {
    if (step_.g.nodes[n].kind != GraphNodeKind::machine) return 1;
    std::vector<std::uint32_t> nodes;
    float sum = 0;
    for (const float weight : states_of(n, step_.g.machines[step_.g.nodes[n].record], nodes)) sum += weight;
    return sum < 1 ? sum : 1.0f;
  }

  void divide_layer(std::uint32_t n, const GraphLayer& layer) {
    const float over = weight_of(step_, layer, step_.own<LayerState>(n)) * presence_of(layer.pose);
    const bool is_laid = layer.mask != kNoIndex || (layer.flags & kLayerIsAdditive) != 0;
    weights_[layer.base] += weights_[n] * (is_laid ? 1.0f : 1.0f - over);
    weights_[layer.pose] += weights_[n] * over;
  }

  GraphStep step_;
  std::vector<float> weights_, times_;
};

}  // namespace

std::vector<ShownNode> shown_nodes(const Animator& animator) {
  if (head_of(animator).is_updated == 0) return {};
  return ShownFinder(animator).find();
}

std::vector<std::uint32_t> nodes_below(const Graph& graph, std::uint32_t node) {
  std::vector<std::uint32_t> out;
  const std::uint32_t record = graph.nodes[node].record;
  if (graph.nodes[node].kind == GraphNodeKind::space) {
    const GraphSpace& space = graph.spaces[record];
    for (std::uint32_t i = 0; i < space.point_count; ++i) out.push_back(graph.points[space.first_point + i].node);
  } else if (graph.nodes[node].kind == GraphNodeKind::machine) {
    const GraphMachine& machine = graph.machines[record];
    for (std::uint32_t i = 0; i < machine.state_count; ++i)
      if (graph.states[machine.first_state + i].node != kNoIndex)
        out.push_back(graph.states[machine.first_state + i].node);
  } else if (graph.nodes[node].kind == GraphNodeKind::layer) {
    out = {graph.layers[record].base, graph.layers[record].pose};
  }
  return out;
}

}  // namespace marrow::tools
