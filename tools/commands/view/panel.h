// The panel of `marrow view`, at the window's left, and the mouse over the picture beside it; by Dear ImGui.
#pragma once

#include "commands/view/actor.h"
#include "commands/view/frame_times.h"
#include "commands/view/view_settings.h"

namespace marrow::tools {

// Of Dear ImGui's context, before its fonts are used.
void set_panel_style(float scale);

// Points.
float panel_width(float scale);

// Widgets for all settings. file: what is on show.
void show_panel(const std::string& file, const Actor& actor, const FrameTimes& times, float scale, Settings& settings);

// Turns, moves and zooms the camera. picture_height: points.
void use_mouse(float picture_height, float radius, Settings& settings);

// Joints and bones over the picture, which begins at `left`. camera: that it was taken by.
void draw_bones(const Actor& actor, const Settings& settings, const Camera& camera, float left);

}  // namespace marrow::tools
