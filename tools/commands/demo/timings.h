// How long the stages take on this processor: medians of many runs.
#pragma once

#include <cstdint>
#include <optional>

#include "commands/demo/worst_place.h"

namespace marrow::tools {

struct Timings {
  double sample_us = 0;  // the clips of one name at one moment, every joint of their skeletons
  double plain_us = 0;   // plain skinning of every mesh, positions and normals
  double as_us = 0;      // the same by animation space
};

// Times the runtime's own calls over memory that is allocated beforehand, at moments spread over the clip. Without a
// clip nothing is sampled and the rest pose is skinned.
Timings measure(const File& file, std::optional<std::uint32_t> clip, PlainSkin& plain);

}  // namespace marrow::tools
