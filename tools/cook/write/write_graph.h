// GRPH of a graph of behaviour.
#pragma once

#include "cook/scene/built.h"
#include "cook/write/names.h"
#include "cook/write/section_bytes.h"

namespace marrow::cook {

// Adds the graph's names to the file's.
Section write_graph(const BuiltGraph& graph, Names& names);

}  // namespace marrow::cook
