// By which deformer and path a character is drawn, or the distance between two deformers as colours.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pose/evaluate.h"
#include "render/figure.h"
#include "render/paths.h"

namespace marrow::tools {

using DeformerPair = std::pair<Deformer, Deformer>;
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
