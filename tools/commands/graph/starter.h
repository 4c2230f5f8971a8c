// `marrow graph new`: a graph to begin with, by what clips are called and measured to do.
#pragma once

#include <string>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

// The text. hero: the character's file, loaded from `path`; packs: files of further clips. It has been cooked and bound
// to these clips. Throws Failure: invalid if there is no clip with a name; what loading throws.
std::string starter_graph(const std::string& path, const File& hero, const std::vector<std::string>& packs);

}  // namespace marrow::tools
