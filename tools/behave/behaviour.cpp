#include "behave/behaviour.h"

#include <algorithm>
#include <cstring>

#include "common/failure.h"
#include "graph/animator_state.h"
#include "pose/choose.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

std::vector<std::string> names_of(const std::vector<Animations>& animations) {
  std::vector<std::string> out;
  for (const Animations& of : animations)
    for (const Animation& animation : of.all) out.emplace_back(animation.name);
  return out;
}

// LINE:COLUMN where a text has a name in quotes first; empty: nowhere.
std::string place_in_text(const std::string& text, const std::string& name) {
  const std::size_t at = std::min(text.find('"' + name + '"'), text.find('\'' + name + '\''));
  if (at == std::string::npos) return "";
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  return std::to_string(line) + ":" + std::to_string(at - begin + 1);
}

}  // namespace

Behaviour::Behaviour(const std::string& path, const File& file, FoundGraph found, const std::vector<std::string>& packs,
                     const AnimatorOptions& options)
    : found_(std::move(found)), options_(options) {
  expect_joints(path, file);
  bind(path, file, packs);
  memory_ = AlignedBytes(animator_bytes(binding_, options_));
  restart();
}

void Behaviour::bind(const std::string& path, const File& file, std::span<const std::string> packs) {
  const auto add = [&](const File& clips) {
    animations_memory_.emplace_back(animations_bytes(file, clips));
    check(make_animations(file, clips, animations_memory_.back(), animations_.emplace_back()));
  };
  for (const std::string& pack : packs) {
    packs_.push_back(load_mrw(pack));
    plays_of_pack(pack, packs_.back().file, path, file);  // says what does not fit
    add(packs_.back().file);
  }
  add(file);
  binding_memory_ = AlignedBytes(graph_binding_bytes(found_.graph, file));
  GraphMisfit misfit;
  const Status status = bind_graph(found_.file, found_.graph, file, {animations_.data(), animations_.size()},
                                   binding_memory_, binding_, &misfit);
  if (status != Status::mismatch) return check(status);
  const std::string rule = std::string(misfit.rule), name = printable(misfit.name);
  const bool is_clip = rule == "a clip of this name";
  const std::string graph = "graph \"" + printable(found_.graph.name) + "\"";
  throw Failure(Exit::usage, found_.path, is_clip ? place_in_text(found_.text, misfit.name) : "",
                is_clip ? graph + " wants a clip \"" + name + "\", which " + path + " has not"
                        : graph + " wants " + rule + ": " + name,
                is_clip ? printable(suggestion(misfit.name, names_of(animations_))) : "it does not fit " + path);
}

void Behaviour::restart() {
  check(make_animator(binding_, options_, memory_, animator_));
  step_ = {};
  place_ = {};
  time_s_ = 0;
}

std::string Behaviour::parameter_name(std::uint32_t parameter) const {
  return found_.file.text(graph().parameters[parameter].name);
}

std::string Behaviour::node_name(std::uint32_t node) const {
  return found_.file.text(graph().nodes[node].name);
}

std::string Behaviour::shown_name(std::uint32_t node) const {
  const GraphNode& of = graph().nodes[node];
  return of.kind == GraphNodeKind::clip && node_name(node).empty() ? found_.file.text(graph().clips[of.record].name)
                                                                   : node_name(node);
}

std::string Behaviour::state_name(std::uint32_t node, std::uint32_t state) const {
  const GraphMachine& machine = graph().machines[graph().nodes[node].record];
  return found_.file.text(graph().states[machine.first_state + state].name);
}

std::uint32_t Behaviour::parameter(const std::string& name) const {
  const std::uint32_t found = find_parameter(binding_, name.c_str());
  if (found < graph().parameters.size) return found;
  std::vector<std::string> names;
  for (std::uint32_t p = 0; p < graph().parameters.size; ++p) names.push_back(parameter_name(p));
  throw Failure(Exit::usage, found_.path, "", "there is no parameter \"" + printable(name) + "\"",
                names.empty() ? "the graph has none" : printable(suggestion(name, names)));
}

void Behaviour::set(std::uint32_t parameter, float value) {
  switch (graph().parameters[parameter].kind) {
    case ParameterKind::number:
      return check(set_number(animator_, parameter, value));
    case ParameterKind::flag:
      return check(set_flag(animator_, parameter, value > 0.5f));
    case ParameterKind::trigger:
      return check(fire(animator_, parameter));
  }
}

float Behaviour::value(std::uint32_t parameter) const {
  const ParameterState& state = parameters_of(animator_.state)[parameter];
  return graph().parameters[parameter].kind == ParameterKind::number ? state.value : state.target;
}

float Behaviour::wanted(std::uint32_t parameter) const {
  return value_of(animator_, parameter);
}

const AnimatorStep& Behaviour::update(float dt_s) {
  check(update_animator(animator_, dt_s, step_));
  place_ = move_root(place_, step_.root);
  time_s_ += static_cast<double>(dt_s);
  return step_;
}

Behaviour::Moment Behaviour::moment() const {
  return {{memory_.data(), memory_.data() + memory_.size()}, step_, place_, time_s_};
}

void Behaviour::go_back(const Moment& moment) {
  // Of plain bytes that point into themselves, and stay where they are.
  std::memcpy(memory_.data(), moment.memory.data(), memory_.size());
  step_ = moment.step;
  place_ = moment.place;
  time_s_ = moment.time_s;
}

void Behaviour::pose(Character& character) {
  std::vector<AnimationLayer> layers;
  for (const ShownNode& n : shown())
    if (n.is_clip) layers.push_back({n.animation, n.time_s, n.weight});
  character.pose(animator_, world_from_model(), layers);
}

std::vector<MachineNow> Behaviour::machines() const {
  std::vector<MachineNow> out;
  for (std::uint32_t n = 0; n < graph().nodes.size; ++n) {
    if (graph().nodes[n].kind != GraphNodeKind::machine) continue;
    MachineNow now{node_name(n), "", 0};
    const std::uint32_t state = state_of(animator_, n, &now.seconds);
    if (state != kNoIndex) now.state = state_name(n, state);
    out.push_back(now);
  }
  return out;
}

}  // namespace marrow::tools
