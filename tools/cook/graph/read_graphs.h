// Files of graphs.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

// Builds what the options ask for, of files that have been read.
std::vector<BuiltGraph> build_graphs(const std::vector<GraphRule>& rules, Notes& notes);

// Notes clips of graphs that are not among the file's: they may come from a pack, so that this is no error. And those
// that stand in a space at their own speed, and have none. graphs: of the rules, in their order.
void warn_of_clips(const std::vector<GraphRule>& rules, const std::vector<BuiltGraph>& graphs,
                   const std::vector<BuiltClip>& clips, Notes& notes);

}  // namespace marrow::cook
