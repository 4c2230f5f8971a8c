#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"
#include "render/overlay/ground.h"

namespace marrow::tools {
namespace {

constexpr float kTimeColumn = 96;          // points
constexpr double kShown_s = 10;            // on the line of time, at least
constexpr std::size_t kMostEventRows = 6;  // beside the feet's
constexpr ImU32 kNow = IM_COL32(255, 255, 255, 200);
// Of states, which need to be told from their neighbours alone.
constexpr ImU32 kStates[] = {IM_COL32(52, 96, 112, 255),  IM_COL32(122, 84, 58, 255),  IM_COL32(70, 104, 66, 255),
                             IM_COL32(104, 78, 118, 255), IM_COL32(128, 108, 54, 255), IM_COL32(72, 84, 128, 255)};

// What a slider over moments and the rows below it agree about.
struct TimeLine {
  double first_s = 0, last_s = 1;
  float left = 0, right = 1;  // points

  float x_of(double time_s) const {
    return left + (right - left) * static_cast<float>((time_s - first_s) / (last_s - first_s));
  }
};

void go(Rehearsal& rehearsal, std::size_t moment, Settings& s) {
  rehearsal.go_to(moment);
  s.playing = false;
}

TimeLine time_slider(Rehearsal& rehearsal, float scale, Settings& s) {
  TimeLine line;
  line.first_s = rehearsal.moment_s(0);
  line.last_s = std::max(rehearsal.moment_s(rehearsal.count() - 1), line.first_s + kShown_s);
  label_to("time", kTimeColumn * scale);
  auto time_s = static_cast<float>(rehearsal.time_s());
  if (slider("##moment", time_s, static_cast<float>(line.first_s), static_cast<float>(line.last_s), "%.2f s"))
    go(rehearsal, rehearsal.moment_at(static_cast<double>(time_s)), s);
  const float grab = 2 + 0.5f * ImGui::GetStyle().GrabMinSize;
  line.left = ImGui::GetItemRectMin().x + grab;
  line.right = ImGui::GetItemRectMax().x - grab;
  return line;
}

// How fast it goes, steps to the moments beside this one, and from the beginning again.
void speed_row(Rehearsal& rehearsal, float scale, Settings& s) {
  const float step = ImGui::GetFrameHeight(), wide = 46 * scale, gap = ImGui::GetStyle().ItemInnerSpacing.x;
  label_to("speed", kTimeColumn * scale);
  ImGui::SetNextItemWidth(-2 * (step + wide) - 4 * gap);
  slider("##speed", s.playback.speed, 0, 2, "%.2f");
  ImGui::SameLine(0, gap);
  if (ImGui::Button("<", {step, 0}) && rehearsal.now() > 0) go(rehearsal, rehearsal.now() - 1, s);
  ImGui::SameLine(0, gap);
  if (ImGui::Button(">", {step, 0})) go(rehearsal, rehearsal.now() + 1, s);
  ImGui::SameLine(0, gap);
  if (ImGui::Button(s.playing ? "pause" : "play", {wide, 0})) s.playing = !s.playing;
  ImGui::SameLine(0, gap);
  if (ImGui::Button("anew", {-1, 0})) rehearsal.restart();
}

// A name, and room to its right. Returns the row's upper edge.
float row(const std::string& name, const TimeLine& line, float height) {
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
  label_to(name, line.left - ImGui::GetWindowPos().x);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::Dummy({-1, height});
  return top;
}

// A band a state, from where it was entered, with its name where there is room.
void machine_row(const Rehearsal& rehearsal, const TimeLine& line, std::uint32_t node, float scale) {
  const float height = ImGui::GetFontSize();
  const float top = row(rehearsal.behaviour().node_name(node), line, height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t from = 0, to = 0; from < rehearsal.count(); from = to) {
    const std::uint32_t state = rehearsal.state_at(from, node);
    while (to < rehearsal.count() && rehearsal.state_at(to, node) == state) ++to;
    if (state == kNoIndex) continue;
    const float left = line.x_of(rehearsal.moment_s(from)),
                right = line.x_of(rehearsal.moment_s(std::min(to, rehearsal.count() - 1)));
    const std::string name = rehearsal.behaviour().state_name(node, state);
    const ImVec2 low(left, top), high(std::max(right, left + scale), top + height);
    list.AddRectFilled(low, high, kStates[state % std::size(kStates)], 2 * scale);
    if (ImGui::IsMouseHoveringRect(low, high)) ImGui::SetTooltip("%s", name.c_str());
    if (right - left < 20 * scale) continue;
    list.PushClipRect(low, {right - 2 * scale, top + height}, true);
    list.AddText({left + 4 * scale, top}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    list.PopClipRect();
  }
}

// A tick an event.
void event_row(const Rehearsal& rehearsal, const TimeLine& line, const std::string& name, float scale,
               const auto& is_its) {
  const float height = 0.8f * ImGui::GetFontSize(), top = row(name, line, height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({line.left, top + 0.5f * height}, {line.right, top + 0.5f * height + 1},
                     ImGui::GetColorU32(ImGuiCol_FrameBg));
  for (const Rehearsal::Event& event : rehearsal.events()) {
    if (!is_its(event)) continue;
    const Rgb rgb = foot_colour(event.role);
    const float x = line.x_of(event.at_s);
    const ImVec2 low(x - 1.5f * scale, top), high(x + 1.5f * scale, top + height);
    list.AddRectFilled(low, high, IM_COL32(rgb[0], rgb[1], rgb[2], 255), scale);
    if (ImGui::IsMouseHoveringRect({low.x - 2, low.y}, {high.x + 2, high.y}))
      ImGui::SetTooltip("%s at %.3f s", event.name.c_str(), event.at_s);
  }
}

void event_rows(const Rehearsal& rehearsal, const TimeLine& line, float scale) {
  std::vector<Role> feet;
  std::vector<std::string> others;
  for (const Rehearsal::Event& event : rehearsal.events()) {
    if (event.role != Role::none) {
      if (std::ranges::find(feet, event.role) == feet.end()) feet.push_back(event.role);
    } else if (std::ranges::find(others, event.name) == others.end()) {
      others.push_back(event.name);
    }
  }
  std::ranges::sort(feet);
  std::ranges::sort(others);
  for (const Role role : feet)
    event_row(rehearsal, line, role_name(role), scale, [&](const auto& event) { return event.role == role; });
  const bool all_fit = others.size() <= kMostEventRows;
  for (std::size_t i = 0; i < others.size() && (all_fit || i + 1 < kMostEventRows); ++i)
    event_row(rehearsal, line, others[i], scale, [&](const auto& event) { return event.name == others[i]; });
  if (all_fit) return;
  event_row(rehearsal, line, "others", scale, [&](const auto& event) {
    return event.role == Role::none &&
           std::ranges::find(others, event.name) - others.begin() + 1 >= static_cast<std::ptrdiff_t>(kMostEventRows);
  });
}

}  // namespace

void time_section(Rehearsal& rehearsal, float scale, Settings& s) {
  if (!section("Time", true)) return;
  const TimeLine line = time_slider(rehearsal, scale, s);
  const float top = ImGui::GetCursorScreenPos().y;
  for (std::uint32_t n = 0; n < rehearsal.behaviour().graph().nodes.size; ++n)
    if (rehearsal.behaviour().graph().nodes[n].kind == GraphNodeKind::machine) machine_row(rehearsal, line, n, scale);
  event_rows(rehearsal, line, scale);
  const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
  const float x = line.x_of(rehearsal.time_s());
  if (bottom > top) ImGui::GetWindowDrawList()->AddLine({x, top}, {x, bottom}, kNow, scale);
  speed_row(rehearsal, scale, s);
}

}  // namespace marrow::tools
