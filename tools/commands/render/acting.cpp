#include "commands/render/acting.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "common/failure.h"

namespace marrow::tools {
namespace {

constexpr double kStepsPerSecond = 60;
constexpr float kAfterScript_s = 2;

using nlohmann::ordered_json;

ordered_json trace_parameters(const Behaviour& behaviour) {
  ordered_json out = ordered_json::object();
  for (std::uint32_t p = 0; p < behaviour.graph().parameters.size; ++p) {
    ordered_json& value = out[behaviour.parameter_name(p)];
    if (behaviour.graph().parameters[p].kind == ParameterKind::number)
      value = behaviour.value(p);
    else
      value = behaviour.value(p) > 0.5f;
  }
  return out;
}

ordered_json trace_states(const Behaviour& behaviour) {
  ordered_json out = ordered_json::object();
  for (const MachineNow& m : behaviour.machines()) {
    ordered_json& now = out[m.machine];
    if (!m.state.empty()) now = {{"state", m.state}, {"seconds", m.seconds}};
  }
  return out;
}

ordered_json trace_shown(const Behaviour& behaviour) {
  ordered_json out = ordered_json::array();
  for (const ShownNode& n : behaviour.shown()) {
    ordered_json& shown = out.emplace_back(ordered_json::object());
    if (const std::string name = behaviour.node_name(n.node); !name.empty()) shown["node"] = name;
    if (n.is_clip) shown["clip"] = n.animation->name;
    shown["weight"] = n.weight;
    if (n.is_clip) shown["time_s"] = n.time_s;
  }
  return out;
}

// A rigid placement: its translation, and how far it is turned about the vertical, to the left.
ordered_json trace_root(const Affine& m) {
  constexpr double kDegrees = 57.29577951308232;
  const double turn = std::atan2(static_cast<double>(m.rows[0][2]), static_cast<double>(m.rows[2][2]));
  return {{"place_m", {m.rows[0][3], m.rows[1][3], m.rows[2][3]}}, {"turn_deg", turn * kDegrees}};
}

}  // namespace

Acting::Acting(const std::string& path, const File& file, const BehaviourArguments& behaviour,
               const ActingArguments& arguments)
    : behaviour_(path, file, find_graph(path, file, behaviour.graph), behaviour.clips), feet_(file) {
  const FoundGraph& found = behaviour_.found();
  if (!arguments.script.empty()) lines_ = read_script(arguments.script, found.file, found.graph);
  const float last_s = lines_.empty() ? 0 : static_cast<float>(lines_.back().time_s);
  duration_s_ = arguments.seconds.value_or(last_s + kAfterScript_s);
}

std::vector<Acting::Met> Acting::play_to(double time_s, const OnStep& on_step) {
  std::vector<Met> met;
  if (now_s_ < 0 || time_s < now_s_) {
    behaviour_.restart();
    prints_.clear();
    next_line_ = 0;
    now_s_ = 0;
    set_what_is_due();
    step(0, on_step, met);
  }
  while (now_s_ < time_s) {
    set_what_is_due();
    double next_s = std::min((std::floor(now_s_ * kStepsPerSecond + 1e-6) + 1) / kStepsPerSecond, time_s);
    if (next_line_ < lines_.size()) next_s = std::min(next_s, lines_[next_line_].time_s);
    const auto dt_s = static_cast<float>(next_s - now_s_);
    now_s_ = next_s;
    step(dt_s, on_step, met);
  }
  return met;
}

void Acting::set_what_is_due() {
  for (; next_line_ < lines_.size() && lines_[next_line_].time_s <= now_s_; ++next_line_)
    behaviour_.set(lines_[next_line_].parameter, lines_[next_line_].value);
}

void Acting::step(float dt_s, const OnStep& on_step, std::vector<Met>& met) {
  for (const AnimatorEvent& e : behaviour_.update(dt_s).events)
    for (std::uint32_t i = 0; i < e.count; ++i) met.push_back({now_s_, e.name, e.animation->name, e.time_s, e.number});
  if (on_step) on_step(dt_s);
}

void Acting::leave_prints(const Character& character) {
  for (const GroundPrint& print : feet_.prints(behaviour_.last_step(), character)) prints_.push_back({print, now_s_});
}

std::optional<float> Acting::ground_height() const {
  std::vector<float> heights;
  for (const Print& p : prints_) heights.push_back(p.print.at.y);
  if (heights.empty()) return std::nullopt;
  std::ranges::sort(heights);
  return heights[heights.size() / 2];
}

std::string trace_text(const std::string& path, Acting& acting, double duration_s, int fps) {
  const Behaviour& behaviour = acting.behaviour();
  ordered_json out = {
      {"file", path}, {"graph", behaviour.graph().name}, {"fps", fps}, {"frames", ordered_json::array()}};
  const auto frames = static_cast<int>(std::floor(duration_s * fps + 1e-6)) + 1;
  for (int i = 0; i < frames; ++i) {
    const double time_s = static_cast<double>(i) / fps;
    ordered_json events = ordered_json::array();
    for (const Acting::Met& e : acting.play_to(time_s))
      events.push_back(
          {{"name", e.name}, {"clip", e.clip}, {"at_s", e.at_s}, {"time_s", e.time_s}, {"number", e.number}});
    out["frames"].push_back({{"time_s", time_s},
                             {"parameters", trace_parameters(behaviour)},
                             {"states", trace_states(behaviour)},
                             {"shown", trace_shown(behaviour)},
                             {"events", events},
                             {"root", trace_root(behaviour.world_from_model())}});
  }
  // A line a frame.
  std::string text = "{\n  \"file\": " + out["file"].dump(-1, ' ', false, ordered_json::error_handler_t::replace) +
                     ",\n  \"graph\": " + out["graph"].dump(-1, ' ', false, ordered_json::error_handler_t::replace) +
                     ",\n  \"fps\": " + std::to_string(fps) + ",\n  \"frames\": [";
  for (std::size_t i = 0; i < out["frames"].size(); ++i)
    text += std::string(i > 0 ? "," : "") + "\n    " +
            out["frames"][i].dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return text + "\n  ]\n}\n";
}

}  // namespace marrow::tools
