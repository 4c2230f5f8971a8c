#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "behave/shown.h"
#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"

namespace marrow::tools {
namespace {

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
