// How a character is to be drawn: what the command lines of `marrow render` and `marrow view` share.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "open/open_model.h"
#include "pose/reach.h"
#include "render/manner.h"

namespace marrow::tools {

struct LookArguments : ModelArguments {
  std::string heatmap;
  std::string images_from;  // as places_of() takes it
  Deformer deformer = Deformer::ssd;
  SkinPath path = SkinPath::ubo;
  AsNormals normals = AsNormals::blended;
  std::string size = "960x720";
  ReachArguments reach;
};

// Width and height, 1 … 8192 each. Throws Failure (usage).
std::pair<int, int> parse_size(const std::string& text);

// "ssd:as" → the two deformers; "" → none. Throws Failure (usage).
std::optional<DeformerPair> parse_pair(const std::string& text);

}  // namespace marrow::tools
