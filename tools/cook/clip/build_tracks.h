// Keys become tracks and channels. Lists of times are shared.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of channels that all belong to one skeleton, or to none: those are left out.
BuiltClip build_tracks(const RawClip& clip, const std::vector<int>& joint_of_node);

// Behind the tracks, which must be final. all_keys: keep those too that others make superfluous.
void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip);

}  // namespace marrow::cook
