// The parts of the panel, and the widgets that they are made of; by Dear ImGui.
#pragma once

#include <string>

#include <imgui.h>

#include "commands/view/view_actor.h"

namespace marrow::tools {

// What plays, and when: seconds and frames.
void clip_section(Actor& actor, float scale, Settings& settings);
// Of a graph: what can be set, and by which keys.
void parameter_section(Rehearsal& rehearsal, float scale, Settings& settings);
// When, back to what is over, with the states of machines and the events on a line of time.
void time_section(Rehearsal& rehearsal, float scale, Settings& settings);
// The nodes below each other: what each weighs, which state a machine is in, where a clip is.
void node_section(const Rehearsal& rehearsal, float scale);
// The tree of joints, the chosen one's transforms, and its curves over the clip.
void joint_section(Actor& actor, float scale, Settings& settings);
// The brush for a joint's weights.
void paint_section(ViewActor& actor, float scale, ViewSettings& settings);
// What is drawn over the picture.
void overlay_section(const Actor& actor, float scale, Settings& settings);
// Limits, goals and springs.
void pose_section(const Actor& actor, float scale, Settings& settings);
// Weights of morph targets.
void morph_section(const Actor& actor, Settings& settings);

// Widgets.

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
