// Meshes compressed with meshoptimizer's vertex and index codecs: several times as fast to decode as Draco, and meant
// to be compressed once more by whatever packs the game's data. Library marrow::meshopt.
#pragma once

#include "marrow/api.h"
#include "marrow/unpack.h"

namespace marrow {

// For unpack(). Allocates nothing.
MARROW_API MeshDecoder meshopt_decoder();

}  // namespace marrow
