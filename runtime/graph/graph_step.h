// A step of an animator, node by node: those before what they take poses of.
#pragma once

#include "graph/animator_state.h"

namespace marrow {

// What a node passes on to one below it.
struct Reach {
  Entry entry = {};
  float loudness = 0;
  bool is_heard = false, is_kept = false;
};

// A graph, its state and what is known of the step by now.
struct GraphStep {
  const GraphBinding& b;
  const Graph& g;
  Span<std::byte> state;
  AnimatorScratch& s;
  double dt_s;

  AnimatorHead& head() const { return head_of(state); }
  ParameterState& parameter(std::uint32_t p) const { return parameters_of(state)[p]; }
  template <class T>
  T& own(std::uint32_t node) const {
    return state_of_node<T>(b, state, node);
  }
  bool is_shown(std::uint32_t node) const { return own<std::uint32_t>(node) != 0; }
  NodeStep& step(std::uint32_t node) const { return s.nodes[node]; }
  LinkStep* links(std::uint32_t node) const { return s.links.data + b.first_link[node]; }

  // Makes sure that a node has its step, at least as those above it want it.
  void reach(std::uint32_t node, const Reach& r) const;
};

// Whether a number is so far from what it is set to that weights change.
bool numbers_change(const GraphStep& step);
// The parameters' values at the end of a step, and their means over it.
void step_parameters(const GraphStep& step);
// At the end of one: triggers whose time is over are set no more. At the end of an update those that do not wait.
void end_triggers(const GraphStep& step);
void drop_brief_triggers(const GraphStep& step);

Status step_clip(const GraphStep& step, std::uint32_t node);
Status step_space(const GraphStep& step, std::uint32_t node);
void step_machine(const GraphStep& step, std::uint32_t node);
void step_layer(const GraphStep& step, std::uint32_t node);

// Weights of a space's points where its numbers are, one a point, and how fast its phase goes.
Status weigh_points(const GraphBinding& b, const GraphSpace& space, const float (&at)[2], float* weights, float& rate);
// Weights of a machine's chain.
void weigh_chain(const MachineState& m, float (&weights)[kMaxFading]);
// Weight of a layer.
float weight_of(const GraphStep& step, const GraphLayer& layer, const LayerState& state);

// Where a clip is at the begin of the step. entered: where it begins, before it is reached; null: it goes on.
Playback playback_of(const GraphStep& step, std::uint32_t node, const Entry* entered);
// The place that a node below which there is a cycle has then; false: it has none. entered: likewise.
bool find_place(const GraphStep& step, std::uint32_t node, const Entry* entered, Phase& out);

// A clip of a space whose clips go by one phase, shift_s before `phase`, by the space's weights.
Status move_back(const GraphStep& step, const GraphSpace& space, const float* weights, float shift_s, Phase& phase);

// Keeps what a step of a clip met, of animations that are heard.
Status hear(const GraphStep& step, const Animation& animation, const Playback& was, const Playback& now, bool first,
            float loudness);

inline void add(const Screw& a, double weight, Screw& sum) {
  sum.turn = sum.turn + a.turn * weight;
  sum.way = sum.way + a.way * weight;
}

}  // namespace marrow
