#include "stage/rehearsal.h"

#include <algorithm>
#include <cmath>

namespace marrow::tools {
namespace {

void forget_after(double time_s, auto& list) {
  while (!list.empty() && list.back().at_s > time_s) list.pop_back();
}
void forget_before(double time_s, auto& list) {
  while (!list.empty() && list.front().at_s < time_s) list.pop_front();
}

}  // namespace

Rehearsal::Rehearsal(const std::string& path, const File& file, FoundGraph found, const std::vector<std::string>& packs)
    : behaviour_(path, file, std::move(found), packs), feet_(file) {
  for (std::uint32_t n = 0; n < behaviour_.graph().nodes.size; ++n)
    if (behaviour_.graph().nodes[n].kind == GraphNodeKind::machine) machines_.push_back(n);
  begin();
}

void Rehearsal::begin() {
  moments_.clear();
  events_.clear();
  prints_.clear();
  way_.clear();
  now_ = 0;
  behaviour_.update(0);
  has_moved_ = true;
}

void Rehearsal::restart() {
  Kept set = kept();
  set.place = {};
  take(set);
}

void Rehearsal::set(std::uint32_t parameter, float value) {
  behaviour_.set(parameter, value);
  if (!has_moved_ && !moments_.empty()) moments_[now_].all = behaviour_.moment();
}

void Rehearsal::move_on(float dt_s) {
  if (!moments_.empty()) moments_.resize(now_ + 1);
  forget_after(time_s(), events_);
  forget_after(time_s(), prints_);
  forget_after(time_s(), way_);
  behaviour_.update(dt_s);
  has_moved_ = true;
}

void Rehearsal::pose(Character& character) {
  behaviour_.pose(character);
  if (std::exchange(has_moved_, false)) remember(character);
}

void Rehearsal::remember(const Character& character) {
  const double at_s = time_s();
  Remembered& last = moments_.emplace_back();
  last.all = behaviour_.moment();
  for (const std::uint32_t node : machines_) last.states.push_back(state_of(behaviour_.animator(), node));
  if (moments_.size() > kMostMoments) moments_.pop_front();
  now_ = moments_.size() - 1;
  const AnimatorStep& step = behaviour_.last_step();
  for (const AnimatorEvent& e : step.events)
    for (std::uint32_t i = 0; i < e.count; ++i) events_.push_back({at_s, e.name, find_role(e.name)});
  for (const GroundPrint& print : feet_.prints(step, character)) prints_.push_back({at_s, print});
  const Affine root = behaviour_.world_from_model();
  way_.push_back({at_s, {root.rows[0][3], root.rows[1][3], root.rows[2][3]}});
  forget_before(moment_s(0), events_);
  forget_before(at_s - kKept_s, prints_);
  forget_before(at_s - kKept_s, way_);
}

std::size_t Rehearsal::moment_at(double time_s) const {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < moments_.size(); ++i)
    if (std::abs(moment_s(i) - time_s) <= std::abs(moment_s(nearest) - time_s)) nearest = i;
  return nearest;
}

std::uint32_t Rehearsal::state_at(std::size_t moment, std::uint32_t node) const {
  const auto machine = std::ranges::find(machines_, node);
  return machine == machines_.end() ? kNoIndex
                                    : moments_[moment].states[static_cast<std::size_t>(machine - machines_.begin())];
}

void Rehearsal::go_to(std::size_t moment) {
  if (moments_.empty()) return;
  now_ = std::min(moment, moments_.size() - 1);
  behaviour_.go_back(moments_[now_].all);
  has_moved_ = false;
}

void Rehearsal::step(std::ptrdiff_t by) {
  go_to(static_cast<std::size_t>(std::max<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(now_) + by, 0)));
}

Rehearsal::Kept Rehearsal::kept() const {
  Kept out;
  out.place = behaviour_.place();
  for (std::uint32_t p = 0; p < behaviour_.graph().parameters.size; ++p) {
    const ParameterKind kind = behaviour_.graph().parameters[p].kind;
    if (kind != ParameterKind::trigger) out.parameters[behaviour_.parameter_name(p)] = {kind, behaviour_.wanted(p)};
  }
  return out;
}

void Rehearsal::take(const Kept& kept) {
  behaviour_.restart();
  for (std::uint32_t p = 0; p < behaviour_.graph().parameters.size; ++p) {
    const auto found = kept.parameters.find(behaviour_.parameter_name(p));
    if (found == kept.parameters.end() || found->second.first != behaviour_.graph().parameters[p].kind) continue;
    behaviour_.set(p, found->second.second);
  }
  behaviour_.place(kept.place);
  begin();
}

std::size_t first_number(const Graph& graph) {
  for (std::size_t p = 0; p < graph.parameters.size; ++p)
    if (graph.parameters[p].kind == ParameterKind::number) return p;
  return 0;
}

}  // namespace marrow::tools
