#include "commands/view/graph_keys.h"

#include <algorithm>

namespace marrow::tools {
namespace {

constexpr float kNudge = 0.05f;  // of a number's range

void use_parameter_keys(Window& window, Rehearsal& rehearsal, Settings& s) {
  const Behaviour& behaviour = rehearsal.behaviour();
  const Span<const GraphParameter> all = behaviour.graph().parameters;
  for (std::uint32_t p = 0; p < kParameterKeys; ++p) {
    if (!window.pressed(kKeyOne + static_cast<int>(p)) || p >= all.size) continue;
    if (all[p].kind == ParameterKind::number) {
      s.parameter = p;
    } else {
      rehearsal.set(p, all[p].kind == ParameterKind::flag && behaviour.wanted(p) > 0.5f ? 0.0f : 1.0f);
    }
  }
  const int by = (window.pressed(kKeyUp) ? 1 : 0) - (window.pressed(kKeyDown) ? 1 : 0);
  if (by == 0 || s.parameter >= all.size || all[s.parameter].kind != ParameterKind::number) return;
  const auto p = static_cast<std::uint32_t>(s.parameter);
  const float step = kNudge * (all[p].most - all[p].least);
  rehearsal.set(p, std::clamp(behaviour.wanted(p) + static_cast<float>(by) * step, all[p].least, all[p].most));
}

}  // namespace

void use_graph_keys(Window& window, Rehearsal& rehearsal, Settings& s) {
  use_parameter_keys(window, rehearsal, s);
  const auto go = [&](int key, bool with_ctrl, const auto& act) {
    if (!window.pressed(key, with_ctrl)) return;
    s.playing = false;
    act();
  };
  go(kKeyLeft, false, [&] { rehearsal.step(-1); });
  go(kKeyLeft, true, [&] { rehearsal.step(-kManyMoments); });
  go(kKeyRight, false, [&] {
    if (rehearsal.now() + 1 < rehearsal.count()) return rehearsal.step(1);
    rehearsal.move_on(kMoment_s);
  });
  go(kKeyRight, true, [&] { rehearsal.step(kManyMoments); });
  go(kKeyHome, false, [&] { rehearsal.go_to(0); });
  go(kKeyEnd, false, [&] { rehearsal.go_to(rehearsal.count()); });
}

}  // namespace marrow::tools
