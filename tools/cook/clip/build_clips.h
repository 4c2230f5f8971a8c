// The source's clips as the file will have them: split by skeleton, compressed, some of them additive.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Clip by clip of the source, in each skeleton by skeleton. built: its skeletons. Throws tools::Failure (usage) if an
// option names what there is not.
std::vector<BuiltClip> build_clips(const RawScene& scene, const BuiltScene& built, const CookOptions& options,
                                   Notes& notes);

}  // namespace marrow::cook
