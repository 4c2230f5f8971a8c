// Clips with left and right exchanged.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Adds the clips that `rules` ask for. `built`: the scene's skeletons, with the pairs of their roles.
//
// A joint moves as its mirror does, reflected in the plane between the pairs: what it has turned and gone in the scene
// since rest, relative to the joint above it. So at rest nothing changes, however a skeleton rests, and a clip that is
// mirrored twice is what it was. A joint without a mirror moves as itself, reflected. Keys keep their times and their
// kind. Numbers, as the weights of morph targets, stay as they are.
//
// Throws tools::Failure (usage) where a rule names no clip, one of several of a name, or a name that there is already;
// and (invalid) where a moved skeleton has no pairs. Not where a rule need not fit.
RawScene with_mirrored_clips(RawScene scene, const BuiltScene& built, const std::vector<MirrorRule>& rules);

}  // namespace marrow::cook
