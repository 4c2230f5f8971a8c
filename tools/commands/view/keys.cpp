#include "commands/view/keys.h"

#include <algorithm>
#include <cstddef>

#include "stage/recording.h"

namespace marrow::tools {
namespace {

constexpr float kNudge = 0.05f;              // of a number's range
constexpr std::ptrdiff_t kManyMoments = 10;  // that Ctrl with an arrow key goes back or on
constexpr float kMoment_s = 1.0f / 60;       // that the arrow key goes on at the end of what was played

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

// A trigger fires, a flag changes, a number is chosen, which up and down change. Left and right go a moment back and
// on, home and end to the oldest and the newest; then it is paused.
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

void use_paint_keys(Window& window, ViewActor& actor, ViewSettings& s) {
  constexpr float kFiner = 0.85f;
  if (window.pressed(kKeySmaller)) s.brush.radius *= kFiner;
  if (window.pressed(kKeyLarger)) s.brush.radius /= kFiner;
  const float all = actor.performance().radius();
  s.brush.radius = std::clamp(s.brush.radius, 0.002f * all, all);
  if (!actor.paints(s)) return;
  if (window.pressed(kKeyZ, true)) actor.painting(s).undo();
  if (window.pressed(kKeyY, true)) actor.painting(s).redo();
  s.save_paint |= window.pressed(kKeyS, true);
}

}  // namespace

void use_keys(Window& window, ViewActor& actor, ViewSettings& s) {
  if (window.pressed(kKeySpace)) s.playing = !s.playing;
  if (actor.rehearsal() != nullptr) return use_graph_keys(window, *actor.rehearsal(), s);
  const float duration_s = actor.plays()[s.clip].play.duration_s, rate = actor.rate_hz(s);
  const auto go = [&](int key, double time_s) {
    if (!window.pressed(key)) return;
    s.playback.time_s = time_s;
    s.playing = false;
  };
  if (s.painting) use_paint_keys(window, actor, s);
  go(kKeyLeft, stepped(s.playback.time_s, -1, duration_s, rate));
  go(kKeyRight, stepped(s.playback.time_s, 1, duration_s, rate));
  go(kKeyHome, 0);
  go(kKeyEnd, time_of_frame(last_frame(duration_s, rate), duration_s, rate));
}

}  // namespace marrow::tools
