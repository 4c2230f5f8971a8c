// Keys become tracks and channels. Lists of times are shared.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Keys become tracks, without loss: the source's values at the source's times. All channels must belong to one
// skeleton; those of no joint are left out.
BuiltClip build_tracks(const RawClip& clip, const std::vector<int>& joint_of_node);

// Numbers over time become channels: constants have one key, superfluous keys are left out unless `all_keys`. The
// clip's tracks must be final.
void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip);

}  // namespace marrow::cook
