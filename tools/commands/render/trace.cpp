#include "commands/render/trace.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace marrow::tools {
namespace {

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
