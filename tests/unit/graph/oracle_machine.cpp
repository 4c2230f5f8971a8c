// What a machine of the oracle does in a stretch of a step: it asks, switches, fades.
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
  now_s_ = run_.begin_s;
  if (run_.fresh || !state_.shown) {
    start();
    fresh_.fresh = true;
    state_.shown = true;
  }
  for (const auto& [n, weight] : state_weights(state_)) played_.insert(n);
  int switches = 0;
  for (;;) {
    Due next;
    if (run_.active && switches < 8) next = due();
    const double fade_end =
        state_.before.empty() ? std::numeric_limits<double>::infinity() : now_s_ + state_.fade_s - state_.since_s;
    double until = std::min(run_.end_s, fade_end);
    if (next.transition != nullptr) until = std::min(until, next.at_s);
    // What is left in the moment in which it is entered was never there.
    const bool is_left_at_once = next.transition != nullptr && next.at_s <= now_s_ && fresh_.fresh;
    if (!is_left_at_once) show_until(until);
    if (fade_end <= until) {
      state_.before.clear();
    }
    if (next.transition != nullptr && next.at_s <= until) {
      take(*next.transition);
      if (++switches == 8) animator_.at_limit = true;
      continue;
    }
    if (until >= run_.end_s) break;
  }
  // A target that is entered at the very end has no time, but begins.
  if (fresh_.fresh || run_.begin_s == run_.end_s) show_until(run_.end_s);
}

// From now on: what is shown, with the mean weights of that time.
void Machine::show_until(double end_s) {
  const double length = end_s - now_s_, whole = run_.end_s - run_.begin_s;
  const bool is_fading = !state_.before.empty();
  const double s =
      is_fading ? mean_smooth(state_.since_s / state_.fade_s, std::min(1.0, (state_.since_s + length) / state_.fade_s))
                : 1;
  if (whole == 0) run_.parts.clear();  // what is shown at last counts
  if (length > 0 || fresh_.fresh || whole == 0) {
    for (const auto& [n, weight] : shares(state_, s)) {
      const bool is_current = n == state_.current;
      if (length == 0 && whole > 0 && !(is_current && fresh_.fresh)) continue;
      const int child = node_.states[static_cast<std::size_t>(n)].node;
      if (child < 0) continue;
      Run run;
      if (is_current) run = fresh_;
      run.begin_s = now_s_;
      run.end_s = end_s;
      run.active = run_.active && is_current;
      run.loud = run_.loud;
      run.from = index_;
      const std::size_t r = animator_.request(child, run);
      run_.parts.push_back({child, r, weight, whole > 0 ? length / whole : 1});
    }
    fresh_ = {};
  }
  state_.since_s += length;
  state_.age_s += length;
  now_s_ = end_s;
}

Machine::Due Machine::due() const {
  Due best;
  for (const bool any : {true, false})
    for (const Transition& t : node_.transitions) {
      if ((t.from < 0) != any) continue;
      if (!any && t.from != state_.current) continue;
      if (any && !t.again && std::find(t.to.begin(), t.to.end(), state_.current) != t.to.end()) continue;
      double at_s = 0;
      if (!is_due(t, at_s) || at_s > run_.end_s) continue;
      if (best.transition == nullptr || at_s < best.at_s) best = {&t, at_s};
    }
  return best;
}

bool Machine::is_due(const Transition& t, double& at_s) const {
  at_s = now_s_;
  if (t.after_s >= 0) at_s = std::max(at_s, now_s_ + t.after_s - state_.age_s);
  if (t.at_end_s >= 0) at_s = std::max(at_s, now_s_ + left_s() - t.at_end_s);
  for (const Condition& c : t.when)
    if (!holds(c, at_s)) return false;
  return true;
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

// Of the current state's clip.
double Machine::left_s() const {
  const int child = node_.states[static_cast<std::size_t>(state_.current)].node;
  NodeState there = animator_.ahead(child);
  if (fresh_.fresh) animator_.begin(child, there, fresh_);
  const Node& clip = animator_.graph_.nodes[static_cast<std::size_t>(child)];
  const double d = clips()[clip.clip].duration_s;
  if (clip.speed == 0) return std::numeric_limits<double>::infinity();
  // To the end that it runs towards.
  const double x = clip.play == Play::once ? there.x : there.x - d * std::floor(there.x / d);
  return (clip.speed > 0 ? d - x : x) / std::abs(clip.speed);
}

Place Machine::phase() const {
  const int child = node_.states[static_cast<std::size_t>(state_.current)].node;
  if (child < 0) return {};
  NodeState there = animator_.ahead(child);
  if (fresh_.fresh) animator_.begin(child, there, fresh_);
  const Node& node = animator_.graph_.nodes[static_cast<std::size_t>(child)];
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
  std::vector<std::pair<int, double>> shown;
  for (const auto& each : state_weights(state_)) {
    if (each.second > 0) shown.push_back(each);
  }
  const bool is_still = std::any_of(shown.begin(), shown.end(), [&](const auto& s) { return s.first == target; });
  const bool is_shown = is_still || played_.count(target) > 0;
  const bool goes_on = is_still && t.enter == Enter::phase;
  Run fresh;
  fresh.fresh = !goes_on;
  fresh.enter = t.enter;
  fresh.enter_s = t.enter_s;
  if (t.enter == Enter::phase && !goes_on) fresh.enter_place = phase();
  const bool inertial = t.inertial || (is_shown && !goes_on);
  if (inertial) animator_.inertia_s_ = std::max(animator_.inertia_s_, t.fade_s + animator_.dt_s_);
  state_.before.clear();
  if (!inertial && t.fade_s > 0) {
    const std::size_t most = 4 - (is_still ? 0 : 1);
    while (shown.size() > most) {
      auto least = shown.end();
      for (auto it = shown.begin(); it != shown.end(); ++it)
        if (it->first != target && (least == shown.end() || it->second < least->second)) least = it;
      shown.erase(least);
    }
    double sum = 0;
    for (const auto& s : shown) sum += s.second;
    for (auto& s : shown) s.second /= sum;
    state_.before = shown;
  }
  state_.fade_s = t.fade_s;
  state_.current = target;
  played_.insert(target);
  state_.since_s = state_.age_s = 0;
  fresh_ = fresh;
}

}  // namespace marrow::test::oracle
