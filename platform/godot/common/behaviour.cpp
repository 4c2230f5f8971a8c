// Graphs of behaviour as a script plays them: animators by numbers, parameters by places in lists.
#include <cmath>

#include "cooked.h"

namespace marrow_godot {
namespace {

template <typename At>
std::string listed(std::size_t count, const At& at) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) (out += i == 0 ? "" : ", ") += at(i);
  return out.empty() ? "it has none" : "it has " + out;
}

}  // namespace

std::vector<std::string> Cooked::graphs() const {
  std::vector<std::string> out;
  const auto add = [&out](const Part& part) {
    for (std::uint32_t i = 0; i < mrw_file_graph_count(&part.file); ++i) {
      mrw_graph graph;
      if (mrw_file_graph(&part.file, i, &graph, nullptr) == MRW_OK) out.emplace_back(graph.name);
    }
  };
  if (character_.skeletons == nullptr) return out;
  add(file_);
  for (const std::unique_ptr<Part>& pack : packs_) add(*pack);
  return out;
}

// Whose graph it is; null: error() says why.
const Cooked::Part* Cooked::find_graph(const std::string& name, mrw_graph& out) {
  for (std::size_t p = 0; p <= packs_.size(); ++p) {
    const Part& part = p == 0 ? file_ : *packs_[p - 1];
    for (std::uint32_t i = 0; i < mrw_file_graph_count(&part.file); ++i) {
      mrw_data_error error;
      mrw_data_error_init(&error);
      if (mrw_file_graph(&part.file, i, &out, &error) != MRW_OK)
        return fail_of(part, std::string(mrw_status_text(error.status)) + ", " + error.rule + ": cook it again"),
               nullptr;
      if (name.empty() || name == out.name) return &part;
    }
  }
  const std::vector<std::string> there = graphs();
  const std::string wanted = name.empty() ? "" : " \"" + name + "\"";
  fail("there is no graph" + wanted + ": " +
       (there.empty() ? "cook it with --graph" : listed(there.size(), [&](std::size_t i) { return there[i]; })));
  return nullptr;
}

std::shared_ptr<Cooked::Bound> Cooked::bind(const Part& source, const mrw_graph& graph) {
  for (const std::shared_ptr<Bound>& each : bound_)
    if (each->binding.graph.nodes == graph.nodes && each->packs == packs_.size()) return each;
  std::vector<mrw_animations> clips{file_.clips};
  for (const std::unique_ptr<Part>& pack : packs_) clips.push_back(pack->clips);
  auto made = std::make_shared<Bound>();
  made->packs = packs_.size();
  mrw_graph_misfit misfit{};
  if (!made->block.make(mrw_graph_binding_bytes(&graph, &file_.file)))
    return fail("there is no memory to play a graph"), nullptr;
  const mrw_status status = mrw_bind_graph(&source.file, &graph, &file_.file, clips.data(), clips.size(),
                                           made->block.data(), made->block.size(), &made->binding, &misfit);
  if (status == MRW_OK) return bound_.emplace_back(std::move(made));
  const std::string wanted =
      misfit.rule == nullptr ? mrw_status_text(status) : std::string(misfit.rule) + ", \"" + misfit.name + "\"";
  fail("the graph \"" + std::string(graph.name) + "\" wants " + wanted +
       ": give it the clips that it was cooked for; add_clips() adds those of a pack");
  return nullptr;
}

std::int64_t Cooked::make_animator(const std::string& name) {
  if (character_.skeletons == nullptr) return fail("nothing is open: call open() first"), -1;
  mrw_graph graph;
  const Part* const source = find_graph(name, graph);
  auto made = std::make_unique<Played>();
  if (source == nullptr || (made->bound = bind(*source, graph)) == nullptr || !make_room(graph.nodes[0].poses))
    return -1;
  mrw_animator_options options;
  mrw_animator_options_init(&options);
  mrw_animator_step_init(&made->step);
  if (!made->block.make(mrw_animator_bytes(&made->bound->binding, &options)))
    return fail("there is no memory to play a graph"), -1;
  const mrw_status status =
      mrw_make_animator(&made->bound->binding, &options, made->block.data(), made->block.size(), &made->animator);
  if (status != MRW_OK) return fail(mrw_status_text(status)), -1;
  std::size_t at = 0;
  while (at < animators_.size() && animators_[at] != nullptr) ++at;
  if (at == animators_.size()) animators_.emplace_back();
  animators_[at] = std::move(made);
  return std::int64_t(at);
}

bool Cooked::free_animator(std::int64_t animator) {
  if (played(animator) == nullptr) return false;
  animators_[std::size_t(animator)] = nullptr;
  return true;
}

Cooked::Played* Cooked::played(std::int64_t animator) {
  if (animator >= 0 && animator < std::int64_t(animators_.size()) && animators_[std::size_t(animator)] != nullptr)
    return animators_[std::size_t(animator)].get();
  fail("there is no animator " + std::to_string(animator) + ": make_animator() gives one");
  return nullptr;
}

std::vector<std::string> Cooked::parameters(std::int64_t animator) {
  std::vector<std::string> out;
  const Played* const p = played(animator);
  if (p == nullptr) return out;
  const mrw_graph_binding& b = p->bound->binding;
  for (std::size_t i = 0; i < b.graph.parameter_count; ++i)
    out.emplace_back(mrw_file_text(&b.file, b.graph.parameters[i].name));
  return out;
}

std::vector<float> Cooked::parameter_reals(std::int64_t animator) {
  std::vector<float> out;
  const Played* const p = played(animator);
  if (p == nullptr) return out;
  const mrw_graph& graph = p->bound->binding.graph;
  for (std::size_t i = 0; i < graph.parameter_count; ++i) {
    const mrw_graph_parameter& each = graph.parameters[i];
    const float value = mrw_value_of(&p->animator, std::uint32_t(i));
    out.insert(out.end(), {float(each.kind), value, each.least, each.most});
  }
  return out;
}

std::int64_t Cooked::find_parameter(std::int64_t animator, const std::string& name) {
  const Played* const p = played(animator);
  if (p == nullptr) return -1;
  const std::size_t found = mrw_find_parameter(&p->bound->binding, name.c_str());
  if (found < p->bound->binding.graph.parameter_count) return std::int64_t(found);
  const std::vector<std::string> there = parameters(animator);
  fail("the graph \"" + std::string(p->bound->binding.graph.name) + "\" has no parameter \"" + name +
       "\": " + listed(there.size(), [&](std::size_t i) { return there[i]; }));
  return -1;
}

bool Cooked::set_parameter(std::int64_t animator, std::int64_t parameter, double value) {
  Played* const p = played(animator);
  if (p == nullptr) return false;
  const mrw_graph_binding& b = p->bound->binding;
  if (parameter < 0 || parameter >= std::int64_t(b.graph.parameter_count))
    return fail("the graph has no parameter " + std::to_string(parameter) + ": find_parameter() gives one");
  const mrw_graph_parameter& set = b.graph.parameters[parameter];
  const std::string name = mrw_file_text(&b.file, set.name);
  if (set.kind == MRW_PARAMETER_KIND_TRIGGER) return fail("\"" + name + "\" is a trigger: fire() it");
  const mrw_status status = set.kind == MRW_PARAMETER_KIND_FLAG
                                ? mrw_set_flag(&p->animator, std::uint32_t(parameter), value != 0)
                                : mrw_set_number(&p->animator, std::uint32_t(parameter), float(value));
  return status == MRW_OK || fail("\"" + name + "\" is set to what is no number");
}

bool Cooked::fire(std::int64_t animator, std::int64_t parameter) {
  Played* const p = played(animator);
  if (p == nullptr) return false;
  const mrw_graph_binding& b = p->bound->binding;
  if (parameter < 0 || parameter >= std::int64_t(b.graph.parameter_count))
    return fail("the graph has no parameter " + std::to_string(parameter) + ": find_parameter() gives one");
  if (b.graph.parameters[parameter].kind != MRW_PARAMETER_KIND_TRIGGER)
    return fail("\"" + std::string(mrw_file_text(&b.file, b.graph.parameters[parameter].name)) +
                "\" is no trigger: set_parameter() sets it");
  return mrw_fire_trigger(&p->animator, std::uint32_t(parameter)) == MRW_OK;
}

std::vector<float> Cooked::update(std::int64_t animator, double dt_s) {
  Played* const p = played(animator);
  if (p == nullptr) return {};
  mrw_animator_step_init(&p->step);
  if (!std::isfinite(dt_s) || dt_s < 0)
    return fail("a graph goes on by seconds that are not below 0"), std::vector<float>();
  const mrw_status status = mrw_update_animator(&p->animator, float(dt_s), &p->step);
  if (status != MRW_OK) return fail(mrw_status_text(status)), std::vector<float>();
  std::vector<float> out(p->step.root.rotation, p->step.root.rotation + 4);
  out.insert(out.end(), p->step.root.translation, p->step.root.translation + 3);
  for (std::size_t i = 0; i < p->step.event_count; ++i) {
    out.push_back(p->step.events[i].number);
    out.push_back(p->step.events[i].time_s);
  }
  return out;
}

std::vector<std::string> Cooked::events(std::int64_t animator) {
  std::vector<std::string> out;
  if (const Played* const p = played(animator))
    for (std::size_t i = 0; i < p->step.event_count; ++i) out.emplace_back(p->step.events[i].name);
  return out;
}

const float* Cooked::pose_graph(std::int64_t animator) {
  Played* const p = played(animator);
  if (p == nullptr) return nullptr;
  const mrw_status status = mrw_sample_animated(&character_, &p->animator, nullptr, 0);
  if (status == MRW_BAD_ARGUMENT) return fail("a graph is posed after its first update()"), nullptr;
  if (status != MRW_OK) return fail(mrw_status_text(status)), nullptr;
  return take_pose();
}

std::string Cooked::state_of(std::int64_t animator, const std::string& machine, double* seconds) {
  error_.clear();
  const Played* const p = played(animator);
  if (seconds != nullptr) *seconds = 0;
  if (p == nullptr) return "";
  const mrw_graph_binding& b = p->bound->binding;
  const std::uint32_t node = mrw_find_graph_node(&b, machine.c_str());
  if (node >= b.graph.node_count || b.graph.nodes[node].kind != MRW_GRAPH_NODE_KIND_MACHINE) {
    std::vector<std::string> there;
    for (std::size_t n = 0; n < b.graph.node_count; ++n)
      if (b.graph.nodes[n].kind == MRW_GRAPH_NODE_KIND_MACHINE)
        there.emplace_back(mrw_file_text(&b.file, b.graph.nodes[n].name));
    fail("the graph has no machine \"" + machine +
         "\": " + listed(there.size(), [&](std::size_t i) { return there[i]; }));
    return "";
  }
  float lasted = 0;
  const std::uint32_t state = mrw_state_of(&p->animator, node, &lasted);
  if (state == MRW_NO_INDEX) return "";
  if (seconds != nullptr) *seconds = double(lasted);
  const mrw_graph_machine& of = b.graph.machines[b.graph.nodes[node].record];
  return mrw_file_text(&b.file, b.graph.states[of.first_state + state].name);
}

mrw_bytes Cooked::state(std::int64_t animator) {
  const Played* const p = played(animator);
  if (p == nullptr) return {};
  return {p->animator.state, p->animator.state_bytes};
}

bool Cooked::restore(std::int64_t animator, const void* bytes, std::size_t size) {
  Played* const p = played(animator);
  if (p == nullptr) return false;
  return mrw_restore_animator(&p->animator, bytes, size) == MRW_OK ||
         fail("these bytes are no state of the graph \"" + std::string(p->bound->binding.graph.name) +
              "\", or are damaged: give what get_state() gave");
}

}  // namespace marrow_godot
