#include <algorithm>

#include <fmt/format.h>

#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"

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

}  // namespace marrow::tools
