// The parts of the panel that have a file of their own.
#pragma once

#include "commands/view/stage/actor.h"
#include "commands/view/stage/view_settings.h"

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
void paint_section(Actor& actor, float scale, Settings& settings);
// What is drawn over the picture.
void overlay_section(const Actor& actor, float scale, Settings& settings);
// Limits, goals and springs.
void pose_section(const Actor& actor, float scale, Settings& settings);
// Weights of morph targets.
void morph_section(const Actor& actor, Settings& settings);

}  // namespace marrow::tools
