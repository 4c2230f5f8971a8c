// Which nodes become joints of which skeleton. A joint is a node that a skin names, that a clip moves, that a game
// or springs move, that lies between two such nodes, or that carries a mesh with nothing of the kind above it. Nodes
// above the joints never move: their product is kept a root.
#pragma once

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// A scene of nothing but skeletons, without limits, and of where each node went. Throws tools::Failure (unsupported)
// for too many joints.
BuiltScene build_skeletons(const RawScene& scene);

}  // namespace marrow::cook
