// Graphs of behaviour: from their text to records that name each other by number.
#pragma once

#include <string>
#include <vector>

#include "cook/graph/graph_text.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// Nodes stand before those whose poses they take, from the output on. A name that is no node is a clip's, and a node of
// its own wherever it is used; where its end is waited for it plays once, else in a loop. A one_shot becomes a layer
// over a machine, a pick a machine. Notes nodes that nothing uses. Throws tools::Failure (usage) at the place of a name
// that is no parameter or state, of nodes that are made of themselves, and of what does not fit its kind.
BuiltGraph build_graph(const GraphText& text, Notes& notes);

}  // namespace marrow::cook
