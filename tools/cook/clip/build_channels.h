// Numbers over time become channels: constants one key, lists of key times shared, superfluous keys left out.
#pragma once

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Behind the tracks, which must be final. all_keys: keep those too that others make superfluous.
void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip);

}  // namespace marrow::cook
