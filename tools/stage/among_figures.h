// What is drawn among the figures: ground grid, wireframe, normals, ghosts; of a character that goes by a graph squares
// to go over, prints of its feet, the root's way.
#pragma once

#include <string>

#include "render/overlay/strokes.h"
#include "stage/actor.h"
#include "stage/settings.h"

namespace marrow::tools {

// A square of the ground grid, metres: the power of ten that is at most a quarter of the radius; and in words, "10 cm".
float grid_square(float radius);
std::string length_of_square(float radius);

// shot: by which the picture is taken. Cost: of normals and wireframe, skinning on the processor.
void add_strokes(Actor& actor, const Settings& settings, const Shot& shot, Strokes& strokes);

}  // namespace marrow::tools
