// How far clips take vertices from where the source has them by what is rounded of morph targets and their weights.
#pragma once

#include "cook/scene/built.h"

namespace marrow::cook {

// At worst, scene units, over the keys of `source`, which has the channels as they were, and the quarters between.
// clip: what became of it; meshes: of all skeletons.
double morph_error_m(const BuiltClip& source, const BuiltClip& clip, const BuiltSkeleton& skeleton,
                     const std::vector<MorphedMesh>& meshes);

}  // namespace marrow::cook
