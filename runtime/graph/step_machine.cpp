// Machines of a graph: which transitions a step takes and when, and what each state has of it.
#include "core/builtins.h"
#include "graph/graph_step.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMostSwitches = 8;

// ∫ smoothstep from 0 to u.
double fade_sum(double u) {
  return u < 1 ? u * u * u * (1.0 - 0.5 * u) : u - 0.5;
}

// What a state has of the step.
struct Played {
  std::uint32_t state;
  float end;
  double from_s, until_s, heard_s;
  double sum_s;  // of its weight
  bool is_left;
  Entry entry;
};

class MachineStep {
 public:
  MachineStep(const GraphStep& step, std::uint32_t node)
      : step_(step),
        m_(step.g.machines[step.g.nodes[node].record]),
        own_(step.own<MachineState>(node)),
        n_(step.step(node)),
        links_(step.links(node)) {}

  void go() {
    for (std::uint32_t i = 0; i < own_.count && own_.is_shown != 0; ++i) {
      Played& p = played(own_.chain[i], n_.from_s);
      if (i == 0) p.heard_s = n_.heard_s;
    }
    if (!n_.entry.begins) {
      decide(n_.from_s, n_.until_s);
    } else {
      if (own_.is_shown != 0 && n_.from_s < n_.entry.at_s) decide(n_.from_s, n_.entry.at_s);
      leave_all(n_.entry.at_s);
      begin();
      decide(n_.entry.at_s, n_.until_s);
    }
    end();
  }

 private:
  std::uint32_t node_of(std::uint32_t state) const { return step_.g.states[m_.first_state + state].node; }

  // From one time of the step to another.
  void decide(double t, double until_s) {
    for (std::uint32_t i = 0; i < kMostSwitches && t <= until_s; ++i) {
      double due = 0;
      const GraphTransition* const next = find_next(t, until_s, due);
      if (next == nullptr) break;
      pass(t, due);
      take(*next, due);
      t = due;
    }
    pass(t, until_s);
  }

  // The state's part of the step, from t on if it has none yet.
  Played& played(std::uint32_t state, double t) {
    for (std::uint32_t i = 0; i < count_; ++i)
      if (all_[i].state == state) return all_[i];
    Played& p = all_[count_++];
    p = {.state = state, .from_s = t, .until_s = t, .heard_s = -1};
    return p;
  }

  std::uint32_t choose(std::uint32_t first, std::uint32_t count, bool in_turn, std::uint32_t other_than) {
    if (count == 1) return first;
    std::uint32_t which = own_.turn++;
    if (!in_turn) {
      std::uint32_t& x = step_.head().chance;
      x ^= x << 13;
      x ^= x >> 17;
      x ^= x << 5;
      which = x;
    }
    const std::uint32_t chosen = first + which % count;
    return chosen != other_than || in_turn ? chosen : first + (which + 1) % count;
  }

  void begin() {
    const MachineState was = own_;
    own_ = {};
    own_.is_shown = was.is_shown;
    own_.turn = was.turn;
    own_.count = 1;
    own_.chain[0] =
        static_cast<std::uint16_t>(choose(m_.start, m_.start_count, (m_.flags & kChooseInTurn) != 0, kNoIndex));
    Played& p = played(own_.chain[0], n_.entry.at_s);
    p.entry = n_.entry;
    p.heard_s = n_.heard_s;
    p.is_left = false;
  }

  bool holds(const GraphCondition& c, double t) const {
    const ParameterState& p = step_.parameter(c.parameter);
    if (step_.g.parameters[c.parameter].kind == ParameterKind::trigger) {
      const bool waits = step_.g.parameters[c.parameter].seconds > 0;
      const bool is_set = p.target != 0 && (!waits || t <= static_cast<double>(p.value));
      return is_set == (c.test == ConditionTest::set);
    }
    switch (c.test) {
      case ConditionTest::set:
        return p.target != 0;
      case ConditionTest::not_set:
        return p.target == 0;
      case ConditionTest::above:
        return p.target > c.value;
      case ConditionTest::below:
        return p.target < c.value;
      case ConditionTest::at_least:
        return p.target >= c.value;
      case ConditionTest::at_most:
        return p.target <= c.value;
    }
    return false;
  }
  bool all_hold(const GraphTransition& transition, double t) const {
    for (std::uint32_t i = 0; i < transition.condition_count; ++i)
      if (!holds(step_.g.conditions[transition.first_condition + i], t)) return false;
    return true;
  }

  // Where a state begins in the step; null: it goes on.
  const Entry* entry_of(std::uint32_t state) const {
    for (std::uint32_t i = 0; i < count_; ++i)
      if (all_[i].state == state && all_[i].entry.begins) return &all_[i].entry;
    return nullptr;
  }

  // When the current state's clip is so near its end; below 0: never.
  double end_of_clip(double t, double before_s) const {
    std::uint32_t node = node_of(own_.chain[0]);
    while (node != kNoIndex && step_.g.nodes[node].kind == GraphNodeKind::layer)
      node = step_.g.layers[step_.g.nodes[node].record].base;
    if (node == kNoIndex || step_.g.nodes[node].kind != GraphNodeKind::clip) return -1;
    const ClipMotion& motion = step_.b.clips[step_.g.nodes[node].record].motion;
    const Playback at = playback_at(step_, node, t, entry_of(own_.chain[0]));
    const bool backwards = (at.speed < 0) != at.returning;
    const double speed = static_cast<double>(at.speed < 0 ? -at.speed : at.speed);
    const double left_s = backwards ? at.time_s : static_cast<double>(motion.duration_s) - at.time_s;
    if (left_s <= before_s * speed) return t;
    return speed > 0 ? t + (left_s / speed - before_s) : -1;
  }

  // The first transition that falls due from t on, while decisions are made; and when.
  const GraphTransition* find_next(double t, double until_s, double& due) const {
    const GraphTransition* best = nullptr;
    for (int any = 1; any >= 0; --any)
      for (std::uint32_t i = 0; i < m_.transition_count; ++i) {
        const GraphTransition& candidate = step_.g.transitions[m_.first_transition + i];
        const std::uint32_t current = own_.chain[0];
        const bool is_there = candidate.to_count == 1 && candidate.to == current;
        if (any == 1 ? candidate.from != kNoIndex || is_there : candidate.from != current) continue;
        double at = t + (static_cast<double>(candidate.after_s) - own_.in_state_s);
        if (!(at > t)) at = t;
        if ((candidate.flags & kWaitsForEnd) != 0) {
          const double end_s = end_of_clip(t, static_cast<double>(candidate.at_end_s));
          if (end_s < 0) continue;
          if (end_s > at) at = end_s;
        }
        const bool decides = at <= until_s && (n_.is_left ? at < n_.heard_s : at <= n_.heard_s);
        if (!decides || (best != nullptr && !(at < due)) || !all_hold(candidate, at)) continue;
        best = &candidate;
        due = at;
      }
    return best;
  }

  // Time goes on in the chain. What fades away is left where its fade ends.
  void pass(double from, double to) {
    const double ends = from + (static_cast<double>(own_.fade_s) - own_.in_state_s);
    if (own_.count > 1 && ends < to) {
      pass_within(from, ends > from ? ends : from);
      own_.count = 1;
      own_.fade_s = 0;
      if (ends > from) from = ends;
    }
    pass_within(from, to);
  }
  void pass_within(double from, double to) {
    const double length = to - from;
    double current = length;
    if (own_.fade_s > 0) {
      const auto fade = static_cast<double>(own_.fade_s);
      current = fade * (fade_sum((own_.in_state_s + length) / fade) - fade_sum(own_.in_state_s / fade));
    }
    for (std::uint32_t i = 0; i < own_.count; ++i) {
      Played& p = played(own_.chain[i], from);
      p.sum_s += i == 0 ? current : static_cast<double>(own_.shares[i - 1]) * (length - current);
      p.until_s = to;
    }
    own_.in_state_s += length;
  }

  void leave_all(double t) {
    for (std::uint32_t i = 0; i < own_.count; ++i) {
      Played& p = played(own_.chain[i], t);
      p.until_s = t;
      silence(p, t);
    }
  }
  static void silence(Played& p, double t) {
    if (p.heard_s <= t && p.is_left) return;
    p.is_left = true;
    if (p.heard_s > t) p.heard_s = t;
  }

  void start_inertia(float fade_s, double t) {
    AnimatorHead& head = step_.head();
    ++head.inertia_count;
    head.inertia_s = fade_s;
    head.inertia_began_s = head.age_s + t;
  }

  // The chain's weights become shares beside a new state. States without weight are dropped; of too many the least.
  void push(std::uint32_t state) {
    float weights[kMaxFading];
    weigh_chain(own_, weights);
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < own_.count; ++i) {
      if (!(weights[i] > 0)) continue;
      weights[kept] = weights[i];
      own_.chain[kept++] = own_.chain[i];
    }
    if (kept == kMaxFading) {
      std::uint32_t least = 0;
      for (std::uint32_t i = 1; i < kept; ++i)
        if (weights[i] < weights[least]) least = i;
      for (std::uint32_t i = least; i + 1 < kept; ++i) {
        weights[i] = weights[i + 1];
        own_.chain[i] = own_.chain[i + 1];
      }
      --kept;
    }
    float sum = 0;
    for (std::uint32_t i = 0; i < kept; ++i) sum += weights[i];
    for (std::uint32_t i = kept; i > 0; --i) {
      own_.chain[i] = own_.chain[i - 1];
      own_.shares[i - 1] = weights[i - 1] / sum;
    }
    own_.chain[0] = static_cast<std::uint16_t>(state);
    own_.count = kept + 1;
  }

  bool is_played(std::uint32_t node) const {
    if (node == kNoIndex) return false;
    if (step_.is_shown(node)) return true;
    for (std::uint32_t i = 0; i < count_; ++i)
      if (node_of(all_[i].state) == node && all_[i].sum_s > 0) return true;
    return false;
  }

  void take(const GraphTransition& transition, double t) {
    for (std::uint32_t i = 0; i < transition.condition_count; ++i) {
      const GraphCondition& c = step_.g.conditions[transition.first_condition + i];
      if (step_.g.parameters[c.parameter].kind == ParameterKind::trigger && c.test == ConditionTest::set)
        step_.parameter(c.parameter) = {};
    }
    const std::uint32_t from = own_.chain[0];
    const std::uint32_t to = choose(transition.to, transition.to_count, (transition.flags & kChooseInTurn) != 0, from);
    const bool was_played = is_played(node_of(to));
    Entry entry{.begins = true, .time_s = transition.enter_s, .at_s = t};
    if ((transition.flags & kEnterInPhase) != 0) {
      entry.begins = !was_played;
      Phase place;
      entry.in_phase = find_place(step_, node_of(from), t, entry_of(from), place);
      entry.share = place.share;
      entry.segment = place.segment;
    }
    const bool restarts = entry.begins && was_played;
    if ((transition.flags & kFadeIsInertial) != 0 || restarts || !(transition.fade_s > 0)) {
      if (transition.fade_s > 0) start_inertia(transition.fade_s, t);
      leave_all(t);
      own_.count = 1;
      own_.chain[0] = static_cast<std::uint16_t>(to);
      own_.fade_s = 0;
    } else {
      for (std::uint32_t i = 0; i < own_.count; ++i) {
        silence(played(own_.chain[i], t), t);
      }
      push(to);
      own_.fade_s = transition.fade_s;
    }
    own_.in_state_s = 0;
    Played& p = played(to, t);
    if (p.until_s < t) {  // it was left in this step
      if (p.until_s > p.from_s && step_.s.cut_s < 0) step_.s.cut_s = p.until_s;
      p.from_s = p.until_s = t;
    }
    p.heard_s = n_.heard_s;
    p.is_left = n_.is_left;
    if (entry.begins) p.entry = entry;
  }

  bool is_in_chain(std::uint32_t state) const {
    for (std::uint32_t i = 0; i < own_.count; ++i)
      if (own_.chain[i] == state) return true;
    return false;
  }

  void end() {
    if (!(own_.in_state_s < static_cast<double>(own_.fade_s))) own_.count = 1;
    if (own_.count == 1) own_.fade_s = 0;
    if (own_.count > 1) step_.s.is_fading = true;
    float weights[kMaxFading];
    weigh_chain(own_, weights);
    for (std::uint32_t i = 0; i < own_.count; ++i) played(own_.chain[i], n_.until_s).end += weights[i];
    for (std::uint32_t i = 0; i < m_.state_count; ++i) links_[i] = {};
    const double whole_s = n_.until_s - n_.from_s;
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Played& p = all_[i];
      const double length = p.until_s - p.from_s;
      links_[p.state] = {length > 0 ? static_cast<float>(p.sum_s / length) : p.end, p.end,
                         whole_s > 0 ? static_cast<float>(length / whole_s) : 1.0f};
      const std::uint32_t node = node_of(p.state);
      // What is left in the moment in which it was entered is as if it had not been.
      if (node == kNoIndex || (!(length > 0) && !is_in_chain(p.state))) continue;
      step_.reach(node, {.entry = p.entry,
                         .from_s = p.from_s,
                         .until_s = p.until_s,
                         .heard_s = p.heard_s,
                         .loudness = n_.loudness,
                         .is_kept = n_.is_kept && is_in_chain(p.state),
                         .is_left = p.is_left || n_.is_left});
    }
  }

  const GraphStep& step_;
  const GraphMachine& m_;
  MachineState& own_;
  const NodeStep& n_;
  LinkStep* links_;
  Played all_[2 * kMaxFading + 2 * kMostSwitches];  // of which as many as count_ are set
  std::uint32_t count_ = 0;
};

}  // namespace

void weigh_chain(const MachineState& m, float (&weights)[kMaxFading]) {
  const float current = m.count == 1 ? 1.0f : fade_weight(Fade::smoothstep, static_cast<float>(m.in_state_s), m.fade_s);
  weights[0] = current;
  for (std::uint32_t i = 1; i < kMaxFading; ++i) weights[i] = i < m.count ? m.shares[i - 1] * (1.0f - current) : 0.0f;
}

void step_machine(const GraphStep& step, std::uint32_t node) {
  MachineStep(step, node).go();
}

}  // namespace marrow
