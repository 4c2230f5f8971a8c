// What a character that goes by a graph leaves on the ground: squares to go over, prints of its feet, the root's way.
#pragma once

#include "commands/view/stage/rehearsal.h"
#include "render/overlay/strokes.h"
#include "render/studio.h"

namespace marrow::tools {

// Up to the moment of now.
void add_way(const Rehearsal& rehearsal, const Shot& shot, Strokes& strokes);

}  // namespace marrow::tools
