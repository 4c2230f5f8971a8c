// How a character is to be drawn: what the command lines of `marrow render` and `marrow view` share.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "open/open_model.h"
#include "pose/reach.h"
#include "render/figure.h"
#include "render/paths.h"

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

using DeformerPair = std::pair<Deformer, Deformer>;
// "ssd:as" → the two deformers; "" → none. Throws Failure (usage).
std::optional<DeformerPair> parse_pair(const std::string& text);

// Deformer and path, or the distance between two deformers as colours.
struct Manner {
  Deformer deformer = Deformer::ssd;
  SkinPath path = SkinPath::ubo;
  std::optional<DeformerPair> heat;  // in place of both
  float heat_scale = 1;              // what the hottest colour stands for, scene units
  const BakedPlay* baked = nullptr;  // of path crowd, blended
};

// The figure in the character's pose; completes `shot`, which has a camera already, and with no box gets the exact one.
// Throws Failure (unsupported) if a mesh of `path` has too many joints for the manner's path.
std::vector<Drawable> drawables_of(const std::string& path, const File& file, const Character& character,
                                   Figure& figure, const Manner& manner, Shot& shot);

}  // namespace marrow::tools
