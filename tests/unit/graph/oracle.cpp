// The oracle's step, node by node as the page has it.
#include "unit/graph/oracle.h"

#include <algorithm>
#include <cmath>

#include "unit/graph/oracle_machine.h"

namespace marrow::test::oracle {

Animator::Animator(Graph made, std::uint32_t seed, double least_loudness)
    : graph_(std::move(made)), least_loudness_(least_loudness), nodes_(graph_.nodes.size()), chance_(seed) {
  for (const Parameter& p : graph_.parameters) values_.push_back({p.initial, p.initial, p.initial, false, 0});
}

void Animator::set_number(const std::string& name, double value) {
  const std::size_t p = graph_.parameter(name);
  values_[p].target = std::clamp(value, graph_.parameters[p].least, graph_.parameters[p].most);
}
void Animator::set_flag(const std::string& name, bool value) {
  values_[graph_.parameter(name)].target = value ? 1 : 0;
}
void Animator::fire(const std::string& name) {
  const std::size_t p = graph_.parameter(name);
  values_[p].is_set = true;
  values_[p].left_s = graph_.parameters[p].seconds;
}

std::string Animator::state(const std::string& node, double* seconds) const {
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    if (graph_.nodes[n].name == node && graph_.nodes[n].kind == Kind::machine && nodes_[n].shown) {
      if (seconds != nullptr) *seconds = nodes_[n].age_s;
      return graph_.nodes[n].states[static_cast<std::size_t>(nodes_[n].current)].name;
    }
  return "";
}

Animator::Everything Animator::everything() const {
  return {values_, nodes_, chance_, root, events, inertia_s_, switches, steps};
}
void Animator::take(const Everything& from) {
  values_ = from.values;
  nodes_ = from.nodes;
  chance_ = from.chance;
  root = from.root;
  events = from.events;
  inertia_s_ = from.inertia_s;
  switches = from.switches;
  steps = from.steps;
}

bool Animator::shows_several() const {
  for (const NodeState& n : nodes_)
    if (n.shown && !n.before.empty()) return true;
  return false;
}
bool Animator::weights_change() const {
  if (shows_several()) return true;
  for (std::size_t p = 0; p < values_.size(); ++p) {
    const Parameter& parameter = graph_.parameters[p];
    const Value& v = values_[p];
    if (parameter.kind == ParameterKind::number && parameter.seconds > 0 &&
        std::abs(v.value - v.target) > (parameter.most - parameter.least) / 64)
      return true;
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = graph_.nodes[n];
    if (node.kind != Kind::layer || !nodes_[n].shown || node.by_parameter < 0) continue;
    const auto p = static_cast<std::size_t>(node.by_parameter);
    if (graph_.parameters[p].kind == ParameterKind::flag && nodes_[n].ramp != values_[p].target) return true;
  }
  return false;
}

void Animator::update(double dt_s) {
  events.clear();
  root = {};
  if (inertia_s_ > 0) inertia_s_ = std::max(0.0, inertia_s_ - dt_s);
  if (first_)
    for (Value& v : values_) v.value = v.target;
  const int count = std::clamp(static_cast<int>(std::ceil(240 * dt_s - 1e-6)), 1, 64);
  bool in_parts = weights_change();
  if (!in_parts) {
    const Everything before = everything();
    several_ = false;
    step(dt_s);
    in_parts = several_;
    if (in_parts) take(before);
  }
  if (in_parts)
    for (int i = 0; i < count; ++i) step(dt_s / count);
  first_ = false;
  for (std::size_t p = 0; p < values_.size(); ++p)
    if (graph_.parameters[p].kind == ParameterKind::trigger && graph_.parameters[p].seconds == 0) {
      values_[p].is_set = false;
    }
}

// Cut where transitions fall due.
void Animator::step(double dt_s) {
  for (int cuts = 0;; ++cuts) {
    const Everything before = everything();
    cut_s_ = -1;
    step_whole(dt_s);
    const double cut_s = cut_s_;
    if (cut_s < 0 || cuts == 16) return;
    take(before);
    step_whole(cut_s);
    dt_s -= cut_s;
  }
}

void Animator::step_whole(double dt_s) {
  ++steps;
  dt_s_ = dt_s;
  step_numbers(dt_s);
  runs_.assign(nodes_.size(), {});
  Run all;
  all.active = true;
  all.loud = 1;
  request(graph_.output, all);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!runs_[n].reached) continue;
    const int i = static_cast<int>(n);
    switch (graph_.nodes[n].kind) {
      case Kind::clip:
        go_clip(i, runs_[n]);
        break;
      case Kind::space:
        go_space(i, runs_[n]);
        break;
      case Kind::machine:
        Machine(*this, i, runs_[n]).go();
        break;
      case Kind::layer:
        go_layer(i, runs_[n]);
        break;
      case Kind::given:
        break;
    }
  }
  for (std::size_t n = nodes_.size(); n-- > 0;)
    if (runs_[n].reached) sum_up(static_cast<int>(n), runs_[n]);
  root = root * exponential(runs_[static_cast<std::size_t>(graph_.output)].root);
  step_triggers(dt_s);
  mark_shown();
}

void Animator::step_numbers(double dt_s) {
  for (std::size_t p = 0; p < values_.size(); ++p) {
    Value& v = values_[p];
    const double h = graph_.parameters[p].seconds;
    if (graph_.parameters[p].kind != ParameterKind::number) continue;
    if (h == 0 || first_) {
      v.value = v.mean = v.target;
      continue;
    }
    const double rounds = dt_s / h * std::log(2.0), left = std::exp(-rounds);
    v.mean = v.target + (v.value - v.target) * (rounds > 0 ? -std::expm1(-rounds) / rounds : 1);
    v.value = static_cast<double>(static_cast<float>(v.target + (v.value - v.target) * left));  // numbers are floats
  }
}

void Animator::step_triggers(double dt_s) {
  for (std::size_t p = 0; p < values_.size(); ++p) {
    Value& v = values_[p];
    if (graph_.parameters[p].kind != ParameterKind::trigger || !v.is_set || graph_.parameters[p].seconds == 0) continue;
    v.left_s -= dt_s;
    if (v.left_s <= 0) v.is_set = false;
  }
}

// A node that several show has one stretch for them all.
void Animator::request(int node, const Run& run) {
  const auto i = static_cast<std::size_t>(node);
  Run& all = runs_[i];
  const double loud = run.active ? run.loud : 0;
  if (!all.reached) {
    all = run;
    all.reached = true;
    all.loud = loud;
    all.fresh = run.fresh || !nodes_[i].shown;
    return;
  }
  all.active = all.active || run.active;
  all.loud = std::max(all.loud, loud);
  if (!run.fresh || all.fresh) return;
  all.fresh = true;
  all.enter = run.enter;
  all.enter_s = run.enter_s;
  all.enter_place = run.enter_place;
}

// What begins anew.
void Animator::begin(int node, NodeState& state, const Run& run) const {
  const Node& n = graph_.nodes[static_cast<std::size_t>(node)];
  state = {};
  if (n.kind == Kind::clip) {
    const Clip& clip = clips()[n.clip];
    state.x = n.speed < 0 ? clip.duration_s : 0;
    if (run.enter == Enter::seconds)  // of what it plays
      state.x += (n.speed < 0 ? -1 : 1) * std::min(run.enter_s, clip.duration_s);
    if (run.enter == Enter::phase) state.x = folded(clip, Play::loop, time_at(clip, run.enter_place));
  } else if (n.in_step && run.enter == Enter::phase) {
    state.place = run.enter_place;
  } else if (n.in_step && run.enter == Enter::seconds) {  // of its first clip
    const Clip& first = clips()[graph_.nodes[static_cast<std::size_t>(n.points[0].node)].clip];
    state.place = place_at(first, std::min(run.enter_s, first.duration_s));
  } else if (n.kind == Kind::layer && n.by_parameter >= 0) {
    state.ramp = values_[static_cast<std::size_t>(n.by_parameter)].target;
  }
  state.shown = true;
}

std::vector<double> Animator::weights(const Node& node, bool mean, double& rate) const {
  const auto value = [&](std::size_t i) { return mean ? values_[node.by[i]].mean : values_[node.by[i]].value; };
  if (node.by.size() == 2) return plane(node, value(0), value(1));
  return node.matches ? matched(graph_, node, value(0), rate) : line(node.points, value(0));
}

void Animator::go_clip(int node, Run& run) {
  const Node& n = graph_.nodes[static_cast<std::size_t>(node)];
  NodeState& state = nodes_[static_cast<std::size_t>(node)];
  if (run.fresh) begin(node, state, run);
  const Clip& clip = clips()[n.clip];
  const double x0 = state.x;
  state.x += n.speed * dt_s_;
  if (n.play == Play::once) state.x = std::clamp(state.x, 0.0, clip.duration_s);
  run.root = root_between(clip, n.play, x0, state.x);
  if (run.active && run.loud >= least_loudness_) count_events(clip, n.play, x0, state.x, run.fresh, events);
}

void Animator::go_space(int node, Run& run) {
  const Node& n = graph_.nodes[static_cast<std::size_t>(node)];
  NodeState& state = nodes_[static_cast<std::size_t>(node)];
  if (run.fresh) begin(node, state, run);
  double rate = 1, unused = 1;
  const std::vector<double> w = weights(n, true, rate), at_end = weights(n, false, unused);
  if (!n.in_step) {
    for (std::size_t i = 0; i < n.points.size(); ++i) {
      if (w[i] <= 0 && at_end[i] <= 0) continue;  // what has no weight is not shown
      Run part;
      part.active = run.active;
      part.loud = run.loud * w[i];
      part.fresh = run.fresh;
      request(n.points[i].node, part);
      run.parts.push_back({n.points[i].node, w[i]});
    }
    return;
  }
  const auto clip_of = [&](std::size_t i) -> const Clip& {
    return clips()[graph_.nodes[static_cast<std::size_t>(n.points[i].node)].clip];
  };
  std::vector<std::pair<const Clip*, double>> group;
  for (std::size_t i = 0; i < w.size(); ++i) group.emplace_back(&clip_of(i), w[i]);
  const Place was = state.place;
  go_on(group, dt_s_ * rate, state.place);
  std::size_t loudest = 0;
  for (std::size_t i = 1; i < w.size(); ++i)
    if (w[i] > w[loudest]) loudest = i;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double x0 = time_at(clip_of(i), was), x1 = time_at(clip_of(i), state.place);
    const Screw each = root_between(clip_of(i), Play::loop, x0, x1);
    run.root.turn += w[i] * each.turn;
    run.root.way += w[i] * each.way;
    if (i == loudest && run.active && run.loud >= least_loudness_)
      count_events(clip_of(i), Play::loop, x0, x1, run.fresh, events);
  }
}

double Animator::layer_weight(const Node& n, const NodeState& state) const {
  if (n.by_parameter < 0) return n.weight;
  const auto p = static_cast<std::size_t>(n.by_parameter);
  if (graph_.parameters[p].kind == ParameterKind::flag) return smooth(state.ramp);
  return std::clamp(values_[p].value, 0.0, 1.0);
}

void Animator::go_layer(int node, Run& run) {
  const Node& n = graph_.nodes[static_cast<std::size_t>(node)];
  NodeState& state = nodes_[static_cast<std::size_t>(node)];
  if (run.fresh) begin(node, state, run);
  const double length = dt_s_;
  run.mean = n.weight;
  if (n.by_parameter >= 0) {
    const auto p = static_cast<std::size_t>(n.by_parameter);
    if (graph_.parameters[p].kind == ParameterKind::number) {
      run.mean = std::clamp(values_[p].mean, 0.0, 1.0);
    } else {
      const double to = values_[p].target, r0 = state.ramp, way = std::abs(to - r0);
      if (n.fade_s > 0 && r0 != to) several_ = true;
      const double can = n.fade_s > 0 ? length / n.fade_s : 1e300;
      const double r1 = can >= way ? to : r0 + (to > r0 ? can : -can);
      if (length > 0 && n.fade_s > 0) {
        const double time = std::min(length, way * n.fade_s);  // then it stays
        run.mean = (time * mean_smooth(std::min(r0, r1), std::max(r0, r1)) + (length - time) * smooth(r1)) / length;
      } else {
        run.mean = smooth(r1);
      }
      state.ramp = r1;
    }
  }
  Run part;
  part.active = run.active;
  part.loud = run.loud * run.mean;
  part.fresh = run.fresh;
  // The base is entered as the layer is.
  Run base = part;
  base.loud = run.loud;
  base.enter = run.enter;
  base.enter_s = run.enter_s;
  base.enter_place = run.enter_place;
  request(n.base, base);
  run.parts.push_back({n.base, 1});
  if (run.mean <= 0 && layer_weight(n, state) <= 0) return;  // what has no weight is not shown
  request(n.pose, part);
  run.parts.push_back({n.pose, 1});
}

void Animator::sum_up(int node, Run& run) {
  const Node& n = graph_.nodes[static_cast<std::size_t>(node)];
  const auto of = [&](std::size_t p) -> const Run& { return runs_[static_cast<std::size_t>(run.parts[p].node)]; };
  const auto add = [&](double w, const Screw& s) {
    run.root.turn += w * s.turn;
    run.root.way += w * s.way;
  };
  if (n.kind == Kind::layer) {
    const double at_hips = n.mask.empty() ? 1 : n.mask[0];
    run.there = of(0).there;
    if (n.additive || run.parts.size() == 1) return add(1, of(0).root);
    // The pose's motion counts already as much as it is there.
    add(1 - run.mean * at_hips * of(1).there, of(0).root);
    add(run.mean * at_hips, of(1).root);
  } else if (n.kind == Kind::machine || (n.kind == Kind::space && !n.in_step)) {
    run.there = 0;
    for (std::size_t p = 0; p < run.parts.size(); ++p) {
      add(run.parts[p].weight, of(p).root);
      run.there += run.parts[p].weight * of(p).there;
    }
  }
}

void Animator::show(int node, std::vector<bool>& shown) const {
  if (node < 0) return;
  const auto i = static_cast<std::size_t>(node);
  shown[i] = true;
  const Node& n = graph_.nodes[i];
  if (n.kind == Kind::space && !n.in_step) {
    double rate = 1;
    const std::vector<double> w = weights(n, false, rate);
    for (std::size_t p = 0; p < w.size(); ++p)
      if (w[p] > 0) show(n.points[p].node, shown);
  }
  if (n.kind == Kind::layer) {
    show(n.base, shown);
    if (layer_weight(n, nodes_[i]) > 0) show(n.pose, shown);
  }
  if (n.kind != Kind::machine || nodes_[i].current < 0) return;
  for (const auto& [s, w] : state_weights(nodes_[i])) show(n.states[static_cast<std::size_t>(s)].node, shown);
}
void Animator::mark_shown() {
  std::vector<bool> shown(nodes_.size(), false);
  show(graph_.output, shown);
  for (std::size_t n = 0; n < nodes_.size(); ++n) nodes_[n].shown = shown[n];
}

}  // namespace marrow::test::oracle
