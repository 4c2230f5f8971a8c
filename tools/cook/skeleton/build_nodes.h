// Nodes that the game asks for by name: sockets, locators, what cameras hang on.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct BuiltNodes {
  std::vector<BuiltNode> nodes;  // in the source's order
  std::vector<Kept> kept;        // a GLOB
};

// Nodes that the source says to keep, and those that `keep` fits: names with wildcards. built: its skeletons. Notes
// what fits nothing and what cannot be carried.
BuiltNodes build_nodes(const RawScene& scene, const BuiltScene& built, const std::vector<std::string>& keep,
                       Notes& notes);

}  // namespace marrow::cook
