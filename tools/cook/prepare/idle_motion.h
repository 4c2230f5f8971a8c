// What clips do to nodes that carry nothing: cameras, lights, empties.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/raw.h"

namespace marrow::cook {

// Of each node whether something at it or below it is drawn, or of a skin that is, or kept: by the source, or by name
// as
// --keep has it; or moved by springs or a game, or has a limit. Where nothing is drawn all nodes do but cameras and
// lights.
std::vector<char> carrying_nodes(const RawScene& scene, const std::vector<std::string>& keep);

// Without motion of nodes that carry nothing, which thus become no joints; a warning names them.
RawScene without_idle_motion(RawScene scene, const std::vector<std::string>& keep, Notes& notes);

}  // namespace marrow::cook
