// Keys become tracks, without loss: the source's values at the source's times. Lists of times are shared.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of channels that all belong to one skeleton, or to none: those are left out.
BuiltClip build_tracks(const RawClip& clip, const std::vector<int>& joint_of_node);

}  // namespace marrow::cook
