// Weights that an artist painted: grey-scale pictures in the place of a texture, or what `marrow view` saves.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with painted weights, of all meshes that are drawn with a skin, by one rule after the other. Notes the
// files. Throws as bind_weights(), read_painted() and paint_places().
RawScene paint_weights(RawScene scene, const std::vector<PaintRule>& rules, Notes& notes);

// A mask as Notes::reads has it. Throws tools::Failure: io, invalid if it is absurdly large.
RawRead read_of_mask(const std::string& path);

}  // namespace marrow::cook
