// The keyboard of the window.
#pragma once

#include "commands/view/view_actor.h"
#include "commands/view/window.h"

namespace marrow::tools {

// Space plays and pauses; the arrows, home and end go through frames. Of a graph, and of painting, their own.
void use_keys(Window& window, ViewActor& actor, ViewSettings& settings);

}  // namespace marrow::tools
