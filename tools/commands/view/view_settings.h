// What the panel of `marrow view` sets: the stage's settings, and the brush.
#pragma once

#include <string>

#include "paint/painting.h"
#include "stage/settings.h"

namespace marrow::tools {

struct ViewSettings : Settings {
  bool painting = false;
  Brush brush;              // of radius 0: one is to be chosen
  std::string paint_file;   // empty: beside the source
  bool save_paint = false;  // to be done, once
};

}  // namespace marrow::tools
