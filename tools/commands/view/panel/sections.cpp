#include "commands/view/panel/sections.h"

#include <cmath>

namespace marrow::tools {
namespace {

constexpr float kLabelWidth = 82;

}  // namespace

void label(const char* words, float scale) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words);
  ImGui::SameLine(kLabelWidth * scale);
  ImGui::SetNextItemWidth(-1);
}

void label_to(const std::string& words, float column) {
  const float room = column - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemSpacing.x;
  std::string shown = words;
  while (shown.size() > 3 && ImGui::CalcTextSize(shown.c_str()).x > room)
    shown = shown.substr(0, shown.size() - 3) + "..";
  ImGui::AlignTextToFramePadding();
  text(shown);
  if (shown != words && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", words.c_str());
  ImGui::SameLine(column);
  ImGui::SetNextItemWidth(-1);
}

bool section(const char* name, bool open) {
  ImGui::Dummy({0, 0.1f * ImGui::GetFontSize()});
  ImGui::PushStyleColor(ImGuiCol_Text, {0.93f, 0.68f, 0.36f, 1});
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyle().Colors[ImGuiCol_FrameBg]);
  const bool shown = ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  ImGui::PopStyleColor(2);
  return shown;
}

void text(const std::string& words) {
  ImGui::TextUnformatted(words.c_str());
}

void quiet(const std::string& words) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
  ImGui::PushTextWrapPos(0);
  text(words);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool slider(const char* id, float& value, float least, float most, const char* format) {
  const float before = value;
  if (!ImGui::SliderFloat(id, &value, least, most, format, ImGuiSliderFlags_AlwaysClamp)) return false;
  if (!std::isfinite(value)) value = before;
  return true;
}

}  // namespace marrow::tools
