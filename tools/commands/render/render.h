// `marrow render`: a cooked character at a moment of a clip → a picture, or over a clip → a moving one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/between.h"
#include "commands/render/viewpoint.h"
#include "render/look.h"

namespace marrow::tools {

struct RenderArguments : LookArguments {
  std::string output;
  std::vector<std::string> outfits;  // that the character wears
  ViewpointArguments viewpoint;
  bool movie = false;
  bool held = false;  // a movie of the moment --time
  int fps = 15;
  bool springs = false;
  BetweenArguments between;
  std::optional<float> turn_deg;
};

// Throws Failure.
void run_render(const RenderArguments& arguments);

}  // namespace marrow::tools
