// `marrow render`: a cooked character at a moment of a clip → a picture, or over a clip → a moving one.
#pragma once

#include <optional>
#include <string>

#include "pose/choose.h"

namespace marrow::tools {

struct RenderArguments {
  std::string file, heatmap, output;
  std::string images_from;  // empty: the file's folder
  std::string deformer = "ssd";
  std::string path = "ubo";
  std::string normals = "tangents";
  std::string size = "960x720";
  std::uint32_t lod = 0;
  Choice choice;
  bool movie = false;
  bool held = false;  // a movie of the moment --time
  int fps = 15;
  std::optional<float> turn_deg;
};

// Throws Failure.
void run_render(const RenderArguments& arguments);

}  // namespace marrow::tools
