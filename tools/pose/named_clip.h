// A clip as a command line names it.
#pragma once

#include <cstdint>
#include <string>

#include "marrow/file.h"

namespace marrow::tools {

struct NamedClip {
  std::uint32_t clip = 0;
  bool alone = false;  // what other skeletons play by the same name does not go with it
};

// By name or else by number; where clips of several skeletons have a name, one of them alone by CLIP@SKELETON, the
// skeleton (of a pack the reference) by name or number, too. Throws Failure (usage) that lists what there is.
NamedClip find_clip(const std::string& path, const File& file, const std::string& wanted);

}  // namespace marrow::tools
