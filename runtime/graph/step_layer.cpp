// Layers of a graph: how much of them is shown, now and in the mean of a step.
#include "graph/graph_step.h"

namespace marrow {
namespace {

float clamped(float w) {
  return !(w > 0) ? 0.0f : w < 1 ? w : 1.0f;
}
float smooth(float r) {
  return r * r * (3.0f - 2.0f * r);
}
// ∫ smooth from 0 to r.
double smooth_sum(double r) {
  return r * r * r * (1.0 - 0.5 * r);
}

// The ramp of a flag after `length_s`, and the mean of its smooth weight over that time.
float ramp_on(float ramp, float target, float fade_s, double length_s, float& mean) {
  const auto from = static_cast<double>(ramp), to = static_cast<double>(target);
  const double whole_s = (to > from ? to - from : from - to) * static_cast<double>(fade_s);
  if (!(length_s > 0)) {
    mean = smooth(ramp);
    return ramp;
  }
  const double moving_s = length_s < whole_s ? length_s : whole_s;
  const double end = whole_s > 0 ? from + (to - from) * (moving_s / whole_s) : to;
  const double moving = end != from ? (smooth_sum(end) - smooth_sum(from)) / (end - from) : 0.0;
  const double still = static_cast<double>(smooth(target)) * (length_s - moving_s);
  mean = static_cast<float>((moving * moving_s + still) / length_s);
  return static_cast<float>(end);
}

}  // namespace

float weight_of(const GraphStep& step, const GraphLayer& layer, const LayerState& state) {
  if (layer.by == kNoIndex) return layer.weight;
  if (step.g.parameters[layer.by].kind == ParameterKind::number) return clamped(step.parameter(layer.by).value);
  return smooth(state.ramp);
}

void step_layer(const GraphStep& step, std::uint32_t node) {
  const GraphLayer& layer = step.g.layers[step.g.nodes[node].record];
  LayerState& own = step.own<LayerState>(node);
  const NodeStep& n = step.step(node);
  LinkStep* const links = step.links(node);
  const bool goes_by_flag = layer.by != kNoIndex && step.g.parameters[layer.by].kind == ParameterKind::flag;
  float mean = 0;
  if (goes_by_flag) {
    const float target = step.parameter(layer.by).target;
    if (n.entry.begins || !(layer.fade_s > 0)) own.ramp = target;
    if (own.ramp != target) step.s.has_changed = true;
    own.ramp = ramp_on(own.ramp, target, layer.fade_s, step.dt_s, mean);
    if (own.ramp != target && n.is_kept) step.s.is_changing = true;
  }
  const float end = weight_of(step, layer, own);
  if (!goes_by_flag) mean = layer.by == kNoIndex ? end : clamped(step.s.means[layer.by]);
  links[0] = {1, 1};
  links[1] = {mean, end};
  Reach down{.entry = n.entry, .loudness = n.loudness, .is_heard = n.is_heard, .is_kept = n.is_kept};
  step.reach(layer.base, down);
  if (!(mean > 0 || end > 0)) return;
  down.entry = n.entry.begins ? Entry{.begins = true} : Entry{};
  down.loudness *= mean;
  down.is_kept = n.is_kept && end > 0;
  step.reach(layer.pose, down);
}

}  // namespace marrow
