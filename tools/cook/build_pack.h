// Clip packs: clips and what they were made for, without the skeletons themselves and without meshes.
#pragma once

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of the scene's own clips for its own skeletons or for `options.onto`, or of options.retarget.clips for either. Throws
// tools::Failure: invalid without clips; usage, unsupported as the stages do.
BuiltScene build_pack(RawScene scene, const CookOptions& options, Notes& notes);

}  // namespace marrow::cook
