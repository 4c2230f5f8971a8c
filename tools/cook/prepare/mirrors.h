// One way to write what a mirror or half a turn may be written in, so that a pose written in two ways blends to itself.
#pragma once

#include "cook/scene/raw.h"

namespace marrow::cook {

// Scales of nodes that may be joints and of their keys become positive, but for x where they mirror. What that turns by
// half a turn, the rotation turns back, so all curves mean the same at every moment. For a clip's node the signs of its
// first keys that have some decide for all keys: where signs change later on, between two keys as well, they go on
// doing so.
RawScene with_one_form_of_mirrors(RawScene scene);

}  // namespace marrow::cook
