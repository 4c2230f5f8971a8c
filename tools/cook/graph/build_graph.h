// Graphs of behaviour: from files of text to records that name each other by number.
#pragma once

#include <vector>

#include "cook/graph/graph_text.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "marrow/blend_space.h"

namespace marrow::cook {

// Nodes stand before those whose poses they take, from the output on. A name that is no node is a clip's, and a node of
// its own wherever it is used; where its end is waited for it plays once, else in a loop. A one_shot becomes a layer
// over a machine, a pick a machine. Notes nodes that nothing uses. Throws tools::Failure (usage) at the place of a name
// that is no parameter or state, of nodes that are made of themselves, and of what does not fit its kind.
BuiltGraph build_graph(const GraphText& text, Notes& notes);

// Builds what the options ask for, of files that have been read.
std::vector<BuiltGraph> build_graphs(const std::vector<GraphRule>& rules, Notes& notes);

// Notes clips of graphs that are not among the file's: they may come from a pack, so that this is no error. And those
// that stand in a space at their own speed, and have none. graphs: of the rules, in their order.
void warn_of_clips(const std::vector<GraphRule>& rules, const std::vector<BuiltGraph>& graphs,
                   const std::vector<BuiltClip>& clips, Notes& notes);

// Counter-clockwise; they cover the points' convex hull. Of points on one circle any diagonals. Empty where two points
// are at one place, or all are on a line. Points: a sweep by x, then flips (C. Lawson, Software for C1 surface
// interpolation, 1977).
std::vector<PlaneTriangle> triangulate(const std::vector<PlanePoint>& points);

}  // namespace marrow::cook
