// What a machine of the oracle does in a step: it asks, switches, fades.
#include "unit/graph/oracle_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace marrow::test::oracle {

double smooth(double u) {
  return u * u * (3 - 2 * u);
}
double mean_smooth(double u0, double u1) {
  if (u1 <= u0) return smooth(u0);
  const auto whole = [](double u) { return u * u * u - u * u * u * u / 2; };
  return (whole(u1) - whole(u0)) / (u1 - u0);
}

namespace {
std::vector<std::pair<int, double>> shares(const NodeState& state, double s) {
  std::vector<std::pair<int, double>> out;
  bool has_current = false;
  for (auto [n, w] : state.before) {
    w *= 1 - s;
    if (n == state.current) {
      w += s;
      has_current = true;
    }
    out.emplace_back(n, w);
  }
  if (!has_current) out.emplace_back(state.current, state.before.empty() ? 1 : s);
  return out;
}
}  // namespace

std::vector<std::pair<int, double>> state_weights(const NodeState& state) {
  return shares(state, state.before.empty() ? 1 : smooth(std::min(1.0, state.since_s / state.fade_s)));
}

// Which of several: the machine counts its choices.
int Animator::chosen(const std::vector<int>& to, bool in_turn, std::size_t& turn, int current) {
  const std::size_t count = to.size();
  if (count == 1) return to[0];
  const std::size_t number = turn++;
  if (in_turn) return to[number % count];
  chance_ ^= chance_ << 13;
  chance_ ^= chance_ >> 17;
  chance_ ^= chance_ << 5;
  const std::size_t out = chance_ % count;
  return to[out] == current ? to[(out + 1) % count] : to[out];
}

void Machine::start() {
  const std::size_t turn = state_.turn;
  state_ = {};
  state_.turn = turn;
  state_.current = animator_.chosen(node_.start, node_.start_in_turn, state_.turn, -1);
  fresh_ = {};
  fresh_.fresh = true;
}

void Machine::go() {
  if (run_.fresh) start();
  if (run_.active) decide();
  if (!state_.before.empty()) animator_.several_ = true;
  show();
}

void Machine::decide() {
  for (int switches = 0; switches < 8; ++switches) {
    const Due next = due();
    if (next.transition == nullptr) return;
    if (next.at_s > 0) {
      if (animator_.cut_s_ < 0 || next.at_s < animator_.cut_s_) animator_.cut_s_ = next.at_s;
      return;
    }
    take(*next.transition);
    if (switches == 7) animator_.at_limit = true;
  }
}

// The states with their mean weights.
void Machine::show() {
  const double dt_s = animator_.dt_s_;
  double s = 1;
  if (!state_.before.empty()) {
    // smooth from since_s to the end of the fade, then 1.
    const double left = std::min(dt_s, state_.fade_s - state_.since_s);
    s = mean_smooth(state_.since_s / state_.fade_s, (state_.since_s + left) / state_.fade_s);
    if (dt_s > 0) s = (s * left + dt_s - left) / dt_s;
  }
  for (const auto& [n, weight] : shares(state_, s)) {
    const bool is_current = n == state_.current;
    if (child(n) < 0) continue;
    Run run;
    if (is_current) run = fresh_;
    run.active = run_.active && is_current;
    run.loud = run_.loud;
    animator_.request(child(n), run);
    run_.parts.push_back({child(n), weight});
  }
  state_.since_s += dt_s;
  state_.age_s += dt_s;
  if (state_.since_s >= state_.fade_s) state_.before.clear();
}

Machine::Due Machine::due() const {
  Due best;
  for (const bool any : {true, false})
    for (const Transition& t : node_.transitions) {
      if ((t.from < 0) != any) continue;
      if (!any && t.from != state_.current) continue;
      if (any && t.to.size() == 1 && t.to[0] == state_.current) continue;
      double at_s = 0;
      if (!is_due(t, at_s) || at_s > animator_.dt_s_) continue;
      if (best.transition == nullptr || at_s < best.at_s) best = {&t, at_s};
    }
  return best;
}

bool Machine::is_due(const Transition& t, double& at_s) const {
  at_s = 0;
  if (t.after_s >= 0) at_s = std::max(at_s, t.after_s - state_.age_s);
  if (t.at_end_s >= 0) at_s = std::max(at_s, left_s() - t.at_end_s);
  if (at_s <= 1e-6) at_s = 0;
  return std::all_of(t.when.begin(), t.when.end(), [&](const Condition& c) { return holds(c, at_s); });
}

bool Machine::holds(const Condition& c, double at_s) const {
  const Animator::Value& v = animator_.values_[c.parameter];
  const Parameter& p = animator_.graph_.parameters[c.parameter];
  bool is_set = v.target != 0;
  if (p.kind == ParameterKind::trigger) is_set = v.is_set && (p.seconds == 0 || at_s < v.left_s);
  switch (c.test) {
    case Test::set:
      return is_set;
    case Test::not_set:
      return !is_set;
    case Test::above:
      return v.target > c.value;
    case Test::below:
      return v.target < c.value;
    case Test::at_least:
      return v.target >= c.value;
    case Test::at_most:
      return v.target <= c.value;
  }
  return false;
}

// What the current state shows, as it is now.
NodeState Machine::current() const {
  const int node = child(state_.current);
  NodeState there = animator_.nodes_[static_cast<std::size_t>(node)];
  if (fresh_.fresh) animator_.begin(node, there, fresh_);
  return there;
}

// Of the current state's clip.
double Machine::left_s() const {
  const NodeState there = current();
  const Node& clip = animator_.graph_.nodes[static_cast<std::size_t>(child(state_.current))];
  const double d = clips()[clip.clip].duration_s;
  if (clip.speed == 0) return std::numeric_limits<double>::infinity();
  // To the end that it runs towards.
  const double x = clip.play == Play::once ? there.x : there.x - d * std::floor(there.x / d);
  return (clip.speed > 0 ? d - x : x) / std::abs(clip.speed);
}

Place Machine::phase() const {
  if (child(state_.current) < 0) return {};
  NodeState there = current();
  const Node& node = animator_.graph_.nodes[static_cast<std::size_t>(child(state_.current))];
  if (node.kind == Kind::space) {  // a group has as many segments as its clips together
    long segments = 1;
    for (const Point& p : node.points)
      segments = std::lcm(
          segments,
          static_cast<long>(clips()[animator_.graph_.nodes[static_cast<std::size_t>(p.node)].clip].marks.size()));
    there.place.segment %= segments;
    return there.place;
  }
  const Clip& clip = clips()[node.clip];
  return place_at(clip, folded(clip, node.play, there.x));
}

void Machine::take(const Transition& t) {
  ++animator_.switches;
  for (const Condition& c : t.when)
    if (animator_.graph_.parameters[c.parameter].kind == ParameterKind::trigger && c.test == Test::set)
      animator_.values_[c.parameter].is_set = false;
  const int target = animator_.chosen(t.to, t.in_turn, state_.turn, state_.current);
  const bool was_shown =
      !run_.fresh && child(target) >= 0 && animator_.nodes_[static_cast<std::size_t>(child(target))].shown;
  const bool goes_on = was_shown && t.enter == Enter::phase;
  Run fresh;
  fresh.fresh = !goes_on;
  fresh.enter = t.enter;
  fresh.enter_s = t.enter_s;
  if (t.enter == Enter::phase && !goes_on) fresh.enter_place = phase();
  const bool inertial = t.inertial || (was_shown && !goes_on);
  const bool fades = t.fade_s > 0 && !(fresh_.fresh && state_.before.empty());  // else nothing was shown
  std::vector<std::pair<int, double>> shown;
  if (fades && !inertial)
    for (const auto& each : state_weights(state_))
      if (each.second > 0) shown.push_back(each);
  if (fades && inertial) animator_.inertia_s_ = std::max(animator_.inertia_s_, t.fade_s + animator_.dt_s_);
  if (shown.size() > 3)
    shown.erase(
        std::min_element(shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.second < b.second; }));
  double sum = 0;
  for (const auto& s : shown) sum += s.second;
  for (auto& s : shown) s.second /= sum;
  state_.before = shown;
  state_.fade_s = shown.empty() ? 0 : t.fade_s;
  state_.current = target;
  state_.since_s = state_.age_s = 0;
  fresh_ = fresh;
}

}  // namespace marrow::test::oracle
