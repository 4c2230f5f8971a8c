// `marrow view`: a character in a window, cooked or to be cooked.
#pragma once

#include <string>
#include <vector>

#include "render/look.h"

namespace marrow::tools {

struct ViewArguments : LookArguments {
  ViewArguments() { size = "1280x800"; }
  bool held = false;  // --time: begin there, paused
  bool bones = false;
  std::vector<std::string> show;  // names of kOverlays, and "uv"
  int ghosts = 0;                 // before and after each
  std::string joint;              // chosen, by name; empty: none
  bool limits = false, springs = false;
  std::string weights;  // joint by name; empty: none
  bool paints = false;
  std::string paint_file;  // empty: beside the source
  std::string screenshot;  // empty: until the window is closed
  int frames = 10;
};

// Throws Failure: unsupported where there is no display.
void run_view(const ViewArguments& arguments);

}  // namespace marrow::tools
