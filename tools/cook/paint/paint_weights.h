// Weights that an artist painted: grey-scale pictures in the place of a texture, or what `marrow view` saves.
#pragma once

#include <vector>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with painted weights, of all meshes that are drawn with a skin, by one rule after the other; their
// files have been read. Throws as bind_weights(), read_painted() and paint_places().
RawScene paint_weights(RawScene scene, const std::vector<PaintRule>& rules, Notes& notes);

}  // namespace marrow::cook
