// Where plain skinning spoils a character most, and is seen to: which clip, when, at which joint, from which side.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "commands/demo/plain_skin.h"
#include "render/clearest_side.h"

namespace marrow::tools {

struct WorstPlace {
  std::optional<std::uint32_t> clip;  // none if there is none
  float time_s = 0;
  std::string joint;  // its name, or without one its number; empty where nothing is to be seen
  Part part;          // about it
  Orbit side;
};

// Of the clips, at moments spread over them; of those that stand still only where all do. A place is bad where
// triangles lose area that animation space leaves them; of the worst places the one whose picture changes most is
// taken. Leaves `character`, of `file`, in some pose.
WorstPlace find_worst(const File& file, Character& character, PlainSkin& plain, std::span<const std::uint32_t> clips);

}  // namespace marrow::tools
