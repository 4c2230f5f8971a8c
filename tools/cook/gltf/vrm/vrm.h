// What VRM avatars say beyond glTF, versions 0 and 1, becomes Marrow's own: springs, limits of eyes, expressions as
// additive clips, properties of kept nodes.
#pragma once

#include "cook/gltf/import/import.h"

namespace marrow::cook::gltf {

// scene: all else of it is imported. A reference to nothing is refused, unless a game can do without, which is a
// warning; a spring that makes no sense is left out with one.
void import_vrm(const Document& document, Budget& budget, Report& report, RawScene& scene);

}  // namespace marrow::cook::gltf
