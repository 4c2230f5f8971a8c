// From streams to a GEOM section: vertices grouped into blocks of floats, as the skinning kernels read them.
#pragma once

#include "core/memory.h"
#include "unpack/arrange.h"
#include "unpack/streams.h"

namespace marrow {

// Bytes of the scratch memory that arrange_geometry() takes.
std::uint64_t expand_scratch_bytes(const MeshStreams& mesh);

// Null, or the rule that is broken, by numbers that nobody has checked: all that is needed to go by them.
const char* check_streams(const MeshStreams& mesh);

// Checks the streams and decides where each vertex goes. Palette entries are for load() to check. Returns null, or the
// rule that is broken. Cost: one sort of the vertices.
const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, Arrangement& out);

// Writes a GEOM section (docs/format.md) to `out`, 16-byte aligned, and its size to `bytes`, from streams that
// arrange_geometry() has arranged. Returns null, or the rule that is broken. Cost: a pass over each stream.
const char* write_geometry(const MeshStreams& mesh, const Arrangement& arrangement, Span<std::byte> out,
                           std::uint32_t& bytes);

}  // namespace marrow
