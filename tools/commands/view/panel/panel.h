// The panel of `marrow view`, at the window's left; by Dear ImGui.
#pragma once

#include <string>

#include "commands/view/frame_times.h"
#include "commands/view/stage/actor.h"
#include "commands/view/stage/view_settings.h"

namespace marrow::tools {

// Of Dear ImGui's context, before its fonts are used.
void set_panel_style(float scale);

// Points.
float panel_width(float scale);

struct PanelState {
  const FrameTimes& times;
  float scale;
};

// Widgets for all settings; it scrolls where the window is low.
void show_panel(const PanelState& state, Actor& actor, Settings& settings);

// Over the picture, which begins at `left`: what is being opened, and why the last file could not be.
void show_notes(const std::string& busy_with, const std::string& error, float left, float scale);

}  // namespace marrow::tools
