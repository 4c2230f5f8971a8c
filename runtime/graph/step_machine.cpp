// Machines of a graph: which transitions a step takes and when, and what each state has of it.
#include "core/builtins.h"
#include "graph/graph_step.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMostSwitches = 8;
constexpr double kNow_s = 1e-6;  // what falls due so soon does so at once: times are rounded

// ∫ smoothstep from 0 to u.
double fade_sum(double u) {
  return u < 1 ? u * u * u * (1.0 - 0.5 * u) : u - 0.5;
}

class MachineStep {
 public:
  MachineStep(const GraphStep& step, std::uint32_t node)
      : step_(step),
        m_(step.g.machines[step.g.nodes[node].record]),
        own_(step.own<MachineState>(node)),
        n_(step.step(node)),
        links_(step.links(node)) {}

  void go() {
    if (n_.entry.begins) begin();
    if (n_.is_heard) decide();
    if (own_.count > 1) step_.s.has_changed = true;
    weigh();
    show();
  }

 private:
  std::uint32_t node_of(std::uint32_t state) const { return step_.g.states[m_.first_state + state].node; }

  // At the begin of the step. What falls due later cuts it there.
  void decide() {
    for (std::uint32_t i = 0; i < kMostSwitches; ++i) {
      double due = 0;
      const GraphTransition* const next = find_next(due);
      if (next == nullptr) return;
      if (due > 0) {
        double& cut_s = step_.s.cut_s;
        if (cut_s < 0 || due < cut_s) cut_s = due;
        return;
      }
      take(*next);
    }
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
    const std::uint32_t is_shown = own_.is_shown, turn = own_.turn;
    own_ = {};
    own_.is_shown = is_shown;
    own_.turn = turn;
    own_.count = 1;
    own_.chain[0] =
        static_cast<std::uint16_t>(choose(m_.start, m_.start_count, (m_.flags & kChooseInTurn) != 0, kNoIndex));
    entry_ = n_.entry;
  }

  bool holds(const GraphCondition& c, double t) const {
    const ParameterState& p = step_.parameter(c.parameter);
    if (step_.g.parameters[c.parameter].kind == ParameterKind::trigger) {
      const bool waits = step_.g.parameters[c.parameter].seconds > 0;
      const bool is_set = p.target != 0 && (!waits || t < static_cast<double>(p.value));
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

  // Where the current state begins; null: it goes on.
  const Entry* entered() const { return entry_.begins ? &entry_ : nullptr; }

  // When the current state's clip is so near its end; below 0: never.
  double end_of_clip(double before_s) const {
    std::uint32_t node = node_of(own_.chain[0]);
    while (node != kNoIndex && step_.g.nodes[node].kind == GraphNodeKind::layer)
      node = step_.g.layers[step_.g.nodes[node].record].base;
    if (node == kNoIndex || step_.g.nodes[node].kind != GraphNodeKind::clip) return -1;
    const ClipMotion& motion = step_.b.clips[step_.g.nodes[node].record].motion;
    const Playback at = playback_of(step_, node, entered());
    const bool backwards = (at.speed < 0) != at.returning;
    const double speed = static_cast<double>(at.speed < 0 ? -at.speed : at.speed);
    const double left_s = backwards ? at.time_s : static_cast<double>(motion.duration_s) - at.time_s;
    if (left_s <= before_s * speed) return 0;
    return speed > 0 ? left_s / speed - before_s : -1;
  }

  // The first transition that falls due in the step, and when: 0 at once.
  const GraphTransition* find_next(double& due) const {
    const GraphTransition* best = nullptr;
    for (int any = 1; any >= 0; --any)
      for (std::uint32_t i = 0; i < m_.transition_count; ++i) {
        const GraphTransition& candidate = step_.g.transitions[m_.first_transition + i];
        const std::uint32_t current = own_.chain[0];
        const bool is_there = candidate.to_count == 1 && candidate.to == current;
        if (any == 1 ? candidate.from != kNoIndex || is_there : candidate.from != current) continue;
        double at = static_cast<double>(candidate.after_s) - own_.in_state_s;
        if ((candidate.flags & kWaitsForEnd) != 0) {
          const double end_s = end_of_clip(static_cast<double>(candidate.at_end_s));
          if (end_s < 0) continue;
          if (end_s > at) at = end_s;
        }
        if (!(at > kNow_s)) at = 0;
        if (at > step_.dt_s || (best != nullptr && !(at < due)) || !all_hold(candidate, at)) continue;
        best = &candidate;
        due = at;
      }
    return best;
  }

  void start_inertia(float fade_s) {
    AnimatorHead& head = step_.head();
    ++head.inertia_count;
    head.inertia_s = fade_s;
  }

  // The chain's weights become shares beside a new state. A current one without weight is dropped; of too
  // many the least.
  void push(std::uint32_t state) {
    float weights[kMaxFading];
    weigh_chain(own_, weights);
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < own_.count; ++i) {
      if (i == 0 && !(weights[i] > 0)) continue;
      std::uint32_t same = 0;
      while (same < kept && own_.chain[same] != own_.chain[i]) ++same;
      weights[same] = same < kept ? weights[same] + weights[i] : weights[i];
      own_.chain[same] = own_.chain[i];
      if (same == kept) ++kept;
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

  void take(const GraphTransition& transition) {
    for (std::uint32_t i = 0; i < transition.condition_count; ++i) {
      const GraphCondition& c = step_.g.conditions[transition.first_condition + i];
      if (step_.g.parameters[c.parameter].kind == ParameterKind::trigger && c.test == ConditionTest::set)
        step_.parameter(c.parameter) = {};
    }
    const std::uint32_t from = own_.chain[0];
    const std::uint32_t to = choose(transition.to, transition.to_count, (transition.flags & kChooseInTurn) != 0, from);
    const bool was_shown = !n_.entry.begins && node_of(to) != kNoIndex && step_.is_shown(node_of(to));
    Entry entry{.begins = true, .time_s = transition.enter_s};
    if ((transition.flags & kEnterInPhase) != 0) {
      entry.begins = !was_shown;
      Phase place;
      entry.in_phase = find_place(step_, node_of(from), entered(), place);
      entry.share = place.share;
      entry.segment = place.segment;
    }
    const bool is_inertial = (transition.flags & kFadeIsInertial) != 0 || (entry.begins && was_shown);
    // From what was entered just now nothing fades.
    const bool fades = transition.fade_s > 0 && (!entry_.begins || own_.count > 1);
    if (fades && !is_inertial) {
      push(to);
      own_.fade_s = transition.fade_s;
    } else {
      if (fades) start_inertia(transition.fade_s);
      own_.count = 1;
      own_.chain[0] = static_cast<std::uint16_t>(to);
      own_.fade_s = 0;
    }
    own_.in_state_s = 0;
    entry_ = entry;
  }

  // Mean weights of the states, then those at the end. own_.chain keeps those whose fade ends.
  void weigh() {
    for (std::uint32_t i = 0; i < m_.state_count; ++i) links_[i] = {};
    shown_ = own_.count;
    if (shown_ == 1) {
      own_.in_state_s += step_.dt_s;
      own_.fade_s = 0;
      links_[own_.chain[0]] = {1, 1};
      return;
    }
    float weights[kMaxFading];
    weigh_chain(own_, weights);
    const auto fade_s = static_cast<double>(own_.fade_s);
    if (step_.dt_s > 0) {
      const double from = own_.in_state_s / fade_s, length = step_.dt_s / fade_s;
      weights[0] = static_cast<float>((fade_sum(from + length) - fade_sum(from)) / length);
      for (std::uint32_t i = 1; i < shown_; ++i) weights[i] = own_.shares[i - 1] * (1.0f - weights[0]);
    }
    for (std::uint32_t i = 0; i < shown_; ++i) links_[own_.chain[i]].mean += weights[i];
    own_.in_state_s += step_.dt_s;
    if (!(own_.in_state_s < fade_s)) own_.count = 1;
    if (own_.count == 1) own_.fade_s = 0;
    if (own_.count > 1 && n_.is_kept) step_.s.is_changing = true;
    weigh_chain(own_, weights);
    for (std::uint32_t i = 0; i < own_.count; ++i) links_[own_.chain[i]].end += weights[i];
  }

  void show() {
    for (std::uint32_t i = 0; i < shown_; ++i) {
      const std::uint32_t node = node_of(own_.chain[i]);
      if (node == kNoIndex) continue;
      step_.reach(node, {.entry = i == 0 ? entry_ : Entry{},
                         .loudness = n_.loudness,
                         .is_heard = n_.is_heard && i == 0,
                         .is_kept = n_.is_kept && i < own_.count});
    }
  }

  const GraphStep& step_;
  const GraphMachine& m_;
  MachineState& own_;
  const NodeStep& n_;
  LinkStep* links_;
  Entry entry_ = {};  // of the current state, if it was entered in this step
  std::uint32_t shown_ = 0;
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
