// Draco's decoders, which stop where data holds more than a mesh was asked to.
#pragma once

#include <vector>

#include <draco/mesh/mesh.h>

#include "unpack/streams.h"

namespace marrow {

// The counts at the start (draco_counts()) are the mesh's at most. False: damaged, or properties that are not those of
// the streams, of which the i-th has the unique id i. These are seen before any is decoded.
bool decode_bounded(Span<const std::byte> bytes, bool edgebreaker, const MeshStreams& mesh,
                    const std::vector<const Stream*>& streams, ::draco::Mesh& out);

}  // namespace marrow
