// Meshes compressed with Google's Draco: the smallest files, about a microsecond a vertex to decode. Library
// marrow::draco.
#pragma once

#include "marrow/api.h"
#include "marrow/unpack.h"

namespace marrow {

// For unpack(). Draco allocates while it decodes and frees all of it again.
MARROW_API MeshDecoder draco_decoder();

}  // namespace marrow
