// What the panel's sections are made of; by Dear ImGui.
#pragma once

#include <string>

#include <imgui.h>

namespace marrow::tools {

// A label, and room for a widget that fills the rest of the line.
void label(const char* text, float scale);
// The same in another column, points; what is too long for it ends in dots.
void label_to(const std::string& text, float column);
// A heading that folds what is below it; whether that is to be seen.
bool section(const char* name, bool open);
void text(const std::string& words);
// Small print, wrapped.
void quiet(const std::string& words);
// A slider that takes no number typed into it that is none.
bool slider(const char* id, float& value, float least, float most, const char* format);

// names[i] for i below count; whether another was chosen.
bool combo(const char* id, std::size_t count, const auto& name, std::size_t& chosen) {
  const std::size_t before = chosen;
  if (!ImGui::BeginCombo(id, name(chosen).c_str(), ImGuiComboFlags_HeightLarge)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(name(i).c_str(), i == chosen)) chosen = i;
    if (i == chosen) ImGui::SetItemDefaultFocus();
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return chosen != before;
}

}  // namespace marrow::tools
