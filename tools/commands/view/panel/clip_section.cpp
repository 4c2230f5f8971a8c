#include <algorithm>

#include <fmt/format.h>

#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"
#include "commands/view/stage/timeline.h"

namespace marrow::tools {
namespace {

// The frame by number, steps to its neighbours, and how many there are a second.
void frame_row(const Actor& actor, float scale, Settings& s) {
  const float duration_s = actor.plays()[s.clip].play.duration_s, rate = actor.rate_hz(s);
  const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto go = [&](double time_s) {
    s.playback.time_s = time_s;
    s.playing = false;
  };
  label("frame", scale);
  int frame = frame_at(static_cast<double>(clip_time(s.playback)), rate);
  const int last = last_frame(duration_s, rate);
  if (ImGui::Button("<", {button, 0})) go(stepped(s.playback.time_s, -1, duration_s, rate));
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(-button - gap);
  const std::string format = fmt::format("%d of {}", last);
  if (ImGui::SliderInt("##frame", &frame, 0, std::max(last, 1), format.c_str(), ImGuiSliderFlags_AlwaysClamp))
    go(time_of_frame(frame, duration_s, rate));
  ImGui::SameLine(0, gap);
  if (ImGui::Button(">", {button, 0})) go(stepped(s.playback.time_s, 1, duration_s, rate));
  label("a second", scale);
  constexpr float kRates[] = {0, 24, 25, 30, 50, 60};
  const auto name = [&](std::size_t i) {
    if (kRates[i] > 0) return fmt::format("{:.0f} frames", kRates[i]);
    const float own = actor.own_rate_hz(s.clip);
    return own > 0 ? fmt::format("{:.0f} frames, the clip's own", own) : std::string("30 frames");
  };
  auto chosen = static_cast<std::size_t>(std::ranges::find(kRates, s.rate_hz) - kRates);
  if (combo("##rate", std::size(kRates), name, chosen)) s.rate_hz = kRates[chosen];
}

}  // namespace

void clip_section(Actor& actor, float scale, Settings& s) {
  const std::vector<NamedPlay>& plays = actor.plays();
  const auto name = [&](std::size_t i) { return plays[i].name; };
  if (!section("Clip", true)) return;
  label("play", scale);
  if (combo("##clip", plays.size(), name, s.clip)) {
    s.playback.time_s = 0;
    s.framed = false;
  }
  const float duration_s = plays[s.clip].play.duration_s;
  ImGui::BeginDisabled(duration_s <= 0);
  label("time", scale);
  float time_s = clip_time(s.playback);
  const std::string format = fmt::format("%.2f of {:.2f} s", static_cast<double>(duration_s));
  if (slider("##time", time_s, 0, std::max(duration_s, 1e-6f), format.c_str())) {
    s.playback.time_s = static_cast<double>(time_s);
    s.playing = false;
  }
  actor.footprints(s).draw_rows(time_s, scale);
  frame_row(actor, scale, s);
  label("speed", scale);
  const float button = 62 * scale;
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  slider("##speed", s.playback.speed, -2, 2, "%.2f");
  ImGui::SameLine();
  if (ImGui::Button(s.playing ? "pause" : "play", {button, 0})) s.playing = !s.playing;
  ImGui::EndDisabled();
  label("blend", scale);
  combo(
      "##second", plays.size(), [&](std::size_t i) { return i == 0 ? std::string("with nothing") : plays[i].name; },
      s.second);
  ImGui::BeginDisabled(s.second == 0);
  label("weight", scale);
  slider("##weight", s.second_weight, 0, 1, "%.2f");
  ImGui::EndDisabled();
}

}  // namespace marrow::tools
