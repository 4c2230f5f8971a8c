// The scene as the stages take it: what the options add to the source before anything is built of it.
#pragma once

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// A new scene: meshes that no node draws are placed, what has no triangles is not drawn, meshes without weights get
// those that the options ask for. Notes what it mends. Throws tools::Failure (invalid: nothing to cook; usage: an
// option fits nothing; unsupported: a limit).
RawScene prepare_scene(RawScene scene, const PrepareOptions& options, Notes& notes);

// Throws tools::Failure (unsupported) if what is drawn would be too much after so many steps of subdivision.
void check_subdivision(const RawScene& scene, int steps);

}  // namespace marrow::cook
