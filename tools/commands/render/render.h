// `marrow render`: a character at a moment of a clip or of a graph → a picture, or over it → a moving one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/between.h"
#include "commands/render/acting.h"
#include "commands/render/viewpoint.h"
#include "render/look.h"

namespace marrow::tools {

struct RenderArguments : LookArguments {
  std::string output;                // empty: nothing is drawn
  std::vector<std::string> outfits;  // that the character wears
  ViewpointArguments viewpoint;
  std::optional<ActingArguments> acting;  // by a graph
  std::optional<bool> camera_follows;     // the character over the ground; of a graph alone
  std::string trace;                      // empty: none
  std::optional<int> film;                // so many moments in one picture
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
