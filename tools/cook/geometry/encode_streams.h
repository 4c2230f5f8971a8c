// Streams → the bytes that a codec of the runtime turns back into them.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// What Draco's ways to predict are chosen for: bytes alone, or bytes as far as they do not make decoding slow.
enum class DracoAim { quick, smallest };

// Draco's edgebreaker, with each stream predicted in the way that serves the aim best. It reorders vertices and
// triangles, and may split vertices where the surface is no manifold: `streams` becomes what decoding yields. Throws
// tools::Failure (internal) if that is not the same surface.
std::vector<std::byte> encode_draco(OwnedStreams& streams, DracoAim aim);

// meshoptimizer's codecs; vertices are put into the order in which the runtime will store them.
std::vector<std::byte> encode_meshopt(OwnedStreams& streams);

}  // namespace marrow::cook
