// `marrow view`: a cooked character in a window.
#pragma once

#include <string>

#include "render/look.h"

namespace marrow::tools {

struct ViewArguments : LookArguments {
  ViewArguments() { size = "1280x800"; }
  bool held = false;  // --time: begin there, paused
  bool bones = false;
  std::string weights;     // joint by name; empty: none
  std::string screenshot;  // empty: until the window is closed
  int frames = 10;
};

// Throws Failure: unsupported where there is no display.
void run_view(const ViewArguments& arguments);

}  // namespace marrow::tools
