// Which clips become additive, and the poses that their changes are taken from.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct AdditiveReference {
  std::string name;                // as AdditiveRule's; empty: an ordinary clip
  std::vector<SoaTransform> pose;  // empty: the rest pose
};

// For each clip its reference, or none; of clips not yet compressed. Throws tools::Failure (usage) if a rule's
// reference is no clip or has no scale where the clip has some, or if it fits no clip and must; a warning if it need
// not.
std::vector<AdditiveReference> additive_references(const std::vector<BuiltSkeleton>& skeletons,
                                                   const std::vector<BuiltClip>& clips,
                                                   const std::vector<AdditiveRule>& rules, Notes& notes);

}  // namespace marrow::cook
