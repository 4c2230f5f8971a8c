// Which joint hangs on which.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Whether `joint` is `above` or below it, at any depth. Both are joints of the skeleton.
inline bool hangs_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t above) {
  while (joint > above && joint >= skeleton.root_count) joint = skeleton.parents[joint];
  return joint == above;
}

}  // namespace marrow
