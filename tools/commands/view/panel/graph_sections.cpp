#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "behave/shown.h"
#include "commands/view/panel/sections.h"
#include "render/overlay/ground.h"

namespace marrow::tools {
namespace {

constexpr float kNarrowest = 82, kWidest = 150;  // of the names, points

std::string name_with_key(const Behaviour& behaviour, std::uint32_t p) {
  return fmt::format("{} {}", p < kParameterKeys ? std::to_string(p + 1) : " ", behaviour.parameter_name(p));
}

// With a mark where it is on its way.
void number(Rehearsal& rehearsal, std::uint32_t p, Settings& s) {
  const GraphParameter& of = rehearsal.behaviour().graph().parameters[p];
  float value = rehearsal.behaviour().wanted(p);
  if (slider("##number", value, of.least, of.most, "%.2f")) {
    rehearsal.set(p, value);
    s.parameter = p;
  }
  if (ImGui::IsItemActivated()) s.parameter = p;
  const float now = rehearsal.behaviour().value(p), wide = of.most - of.least;
  if (now == rehearsal.behaviour().wanted(p) || !(wide > 0)) return;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  const float x = from.x + (to.x - from.x) * (now - of.least) / wide;
  ImGui::GetWindowDrawList()->AddLine({x, from.y}, {x, to.y}, ImGui::GetColorU32(ImGuiCol_Text), 2);
}

void flag(Rehearsal& rehearsal, std::uint32_t p) {
  bool is_set = rehearsal.behaviour().wanted(p) > 0.5f;
  if (ImGui::Checkbox(is_set ? "true" : "false", &is_set)) rehearsal.set(p, is_set ? 1.0f : 0.0f);
}

// Bright while it waits for its moment.
void trigger(Rehearsal& rehearsal, std::uint32_t p) {
  const bool waits = rehearsal.behaviour().wanted(p) > 0.5f;
  if (waits) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_ButtonActive]);
  if (ImGui::Button(waits ? "waits" : "fire", {-1, 0})) rehearsal.set(p, 1);
  if (waits) ImGui::PopStyleColor();
}

constexpr float kTimeColumn = 96;          // points
constexpr double kShown_s = 10;            // on the line of time, at least
constexpr std::size_t kMostEventRows = 6;  // beside the feet's
constexpr ImU32 kNowLine = IM_COL32(255, 255, 255, 200);
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

constexpr float kNameColumn = 148, kBar = 48, kIndent = 9;  // points
constexpr float kFaint = 0.45f;                             // of what is not shown

// Nodes as they hang below the output, each where it is met first. The layer that a `one_shot` is made of has no name,
// and is left out: its machine has.
struct Row {
  std::uint32_t node;
  int depth;
};
std::vector<Row> rows_of(const Behaviour& behaviour) {
  const Graph& graph = behaviour.graph();
  std::vector<Row> out, next{{0, 0}};
  std::vector<bool> met(graph.nodes.size, false);
  while (!next.empty()) {
    const Row row = next.back();
    next.pop_back();
    if (met[row.node]) continue;
    met[row.node] = true;
    const bool is_listed = !behaviour.shown_name(row.node).empty();
    if (is_listed) out.push_back(row);
    const std::vector<std::uint32_t> below = nodes_below(graph, row.node);
    for (auto node = below.rbegin(); node != below.rend(); ++node)
      next.push_back({*node, row.depth + (is_listed ? 1 : 0)});
  }
  return out;
}

// How much, as a bar and in hundredths.
void bar(float weight, float scale) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = kBar * scale, height = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), 2 * scale);
  if (weight > 0)
    list.AddRectFilled(at, {at.x + width * std::min(weight, 1.0f), at.y + height}, ImGui::GetColorU32(ImGuiCol_Header),
                       2 * scale);
  const std::string words = weight > 0 ? fmt::format("{:.2f}", static_cast<double>(weight)) : "";
  list.AddText({at.x + 0.5f * (width - ImGui::CalcTextSize(words.c_str()).x), at.y}, ImGui::GetColorU32(ImGuiCol_Text),
               words.c_str());
  ImGui::Dummy({width, height});
}

// Which state, and for how long; where in its clip.
std::string note_of(const Behaviour& behaviour, const ShownNode& shown) {
  if (shown.is_clip) return fmt::format("{:.2f} s", static_cast<double>(shown.time_s));
  if (behaviour.graph().nodes[shown.node].kind != GraphNodeKind::machine) return "";
  float seconds = 0;
  const std::uint32_t state = state_of(behaviour.animator(), shown.node, &seconds);
  if (state == kNoIndex) return "";
  return fmt::format("{} {:.1f} s", behaviour.state_name(shown.node, state), static_cast<double>(seconds));
}

}  // namespace

void parameter_section(Rehearsal& rehearsal, float scale, Settings& s) {
  const Behaviour& behaviour = rehearsal.behaviour();
  if (!section("Parameters", true)) return;
  const Span<const GraphParameter> all = behaviour.graph().parameters;
  if (all.empty()) return quiet("The graph has none.");
  float column = kNarrowest * scale;
  for (std::uint32_t p = 0; p < all.size; ++p)
    column = std::max(column, ImGui::CalcTextSize(name_with_key(behaviour, p).c_str()).x +
                                  ImGui::GetStyle().WindowPadding.x + 2 * ImGui::GetStyle().ItemSpacing.x);
  column = std::min(column, kWidest * scale);
  for (std::uint32_t p = 0; p < all.size; ++p) {
    ImGui::PushID(static_cast<int>(p));
    const bool by_keys = all[p].kind == ParameterKind::number && p == s.parameter;
    if (by_keys) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_CheckMark]);
    label_to(name_with_key(behaviour, p), column);
    if (by_keys) ImGui::PopStyleColor();
    if (all[p].kind == ParameterKind::number) number(rehearsal, p, s);
    if (all[p].kind == ParameterKind::flag) flag(rehearsal, p);
    if (all[p].kind == ParameterKind::trigger) trigger(rehearsal, p);
    ImGui::PopID();
  }
}

void time_section(Rehearsal& rehearsal, float scale, Settings& s) {
  if (!section("Time", true)) return;
  const TimeLine line = time_slider(rehearsal, scale, s);
  const float top = ImGui::GetCursorScreenPos().y;
  for (std::uint32_t n = 0; n < rehearsal.behaviour().graph().nodes.size; ++n)
    if (rehearsal.behaviour().graph().nodes[n].kind == GraphNodeKind::machine) machine_row(rehearsal, line, n, scale);
  event_rows(rehearsal, line, scale);
  const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
  const float x = line.x_of(rehearsal.time_s());
  if (bottom > top) ImGui::GetWindowDrawList()->AddLine({x, top}, {x, bottom}, kNowLine, scale);
  speed_row(rehearsal, scale, s);
}

void node_section(const Rehearsal& rehearsal, float scale) {
  if (!section("Nodes and their weights", true)) return;
  const Behaviour& behaviour = rehearsal.behaviour();
  std::map<std::uint32_t, ShownNode> shown;
  for (const ShownNode& node : behaviour.shown()) shown[node.node] = node;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * scale});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  for (const Row& row : rows_of(behaviour)) {
    const auto found = shown.find(row.node);
    const bool is_shown = found != shown.end();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, is_shown ? 1 : kFaint);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + kIndent * scale * static_cast<float>(row.depth));
    label_to(behaviour.shown_name(row.node), kNameColumn * scale);
    bar(is_shown ? found->second.weight : 0, scale);
    if (is_shown) {
      ImGui::SameLine();
      ImGui::TextDisabled("%s", note_of(behaviour, found->second).c_str());
    }
    ImGui::PopStyleVar();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace marrow::tools
