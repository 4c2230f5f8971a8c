// Joints and weights that stand apart from what Draco has compressed.
#pragma once

#include "unpack/streams.h"

namespace marrow {

// Whether a mesh's skin can be: it has one, whose numbers fit.
bool has_skin_for_bits(const MeshStreams& mesh);

// Fills in the streams of joints and weights; the triangles and positions are there. False: the bits are none of such a
// mesh. Allocates a few numbers a vertex.
bool decode_skin(Span<const std::byte> bits, const MeshStreams& mesh);

}  // namespace marrow
