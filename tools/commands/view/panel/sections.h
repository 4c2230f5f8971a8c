// The parts of the panel that have a file of their own.
#pragma once

#include "commands/view/stage/actor.h"
#include "commands/view/stage/view_settings.h"

namespace marrow::tools {

// What plays, and when: seconds and frames.
void clip_section(Actor& actor, float scale, Settings& settings);
// The tree of joints, the chosen one's transforms, and its curves over the clip.
void joint_section(Actor& actor, float scale, Settings& settings);
// The brush for a joint's weights.
void paint_section(Actor& actor, float scale, Settings& settings);
// What is drawn over the picture.
void overlay_section(const Actor& actor, float scale, Settings& settings);
// Limits, goals and springs.
void pose_section(const Actor& actor, float scale, Settings& settings);
// Weights of morph targets.
void morph_section(const Actor& actor, Settings& settings);

}  // namespace marrow::tools
