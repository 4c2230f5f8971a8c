// From streams to a GEOM section: vertices grouped into blocks of floats, as the skinning kernels read them.
#pragma once

#include "core/memory.h"
#include "unpack/streams.h"

namespace marrow {

// Bytes of the scratch memory that expand_geometry() takes.
std::uint64_t expand_scratch_bytes(const MeshStreams& mesh);

// Writes a GEOM section (docs/format.md) to `out`, 16-byte aligned, and its size to `bytes`. Checks indices, the source
// map and weights; palette entries are for load() to check. Returns null, or the rule that is broken. Cost: one sort of
// the vertices and a pass over each stream.
const char* expand_geometry(const MeshStreams& mesh, Memory& scratch, Span<std::byte> out, std::uint32_t& bytes);

}  // namespace marrow
