// Files of graphs.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

// Reads and builds what the options ask for. Files are added to `reads`. Notes clips that are not among the file's;
// null: all come from other files.
std::vector<BuiltGraph> read_graphs(const std::vector<GraphRule>& rules, const std::vector<BuiltClip>* clips,
                                    std::vector<RawRead>& reads, Notes& notes);

}  // namespace marrow::cook
