// The keyboard of a window that plays a graph.
#pragma once

#include <cstddef>

#include "commands/view/stage/rehearsal.h"
#include "commands/view/stage/view_settings.h"
#include "commands/view/window.h"

namespace marrow::tools {

// What one press of Ctrl with an arrow key goes back or on.
inline constexpr std::ptrdiff_t kManyMoments = 10;
// What the arrow key goes on at the end of what was played, seconds.
inline constexpr float kMoment_s = 1.0f / 60;

// Its own: a trigger fires, a flag changes, a number is chosen, which up and down change. Left and right go a moment
// back and on, home and end to the oldest and the newest; then it is paused.
void use_graph_keys(Window& window, Rehearsal& rehearsal, Settings& settings);

}  // namespace marrow::tools
