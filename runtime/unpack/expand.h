// From streams to a GEOM section: vertices grouped into blocks of floats, as the skinning kernels read them.
#pragma once

#include "core/memory.h"
#include "unpack/arrange.h"
#include "unpack/streams.h"

namespace marrow {

// Bytes of the scratch memory that arrange_geometry() takes.
std::uint64_t expand_scratch_bytes(const MeshStreams& mesh);

// Checks untrusted streams as far as is needed to use them safely. Returns null, or the rule that is broken.
const char* check_streams(const MeshStreams& mesh);

// Goes on with checking the streams and deciding where each vertex goes, until `left` is used up or work.place is
// `done`. Palette entries are for load() to check. Returns null, or the rule that is broken. Cost: one sort of the
// vertices.
const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, ArrangingInWork& work, Arrangement& out,
                             std::uint32_t& left);
// All at once.
const char* arrange_geometry(const MeshStreams& mesh, Memory& scratch, Arrangement& out);

// The next morph target or example of a geometry, its first stream, and the blocks and records of those before it.
struct TargetsInWork {
  std::uint32_t target = 0, stream = 0, blocks = 0, records = 0;
};
// The state of write_geometry() between steps.
struct WritingInWork {
  enum class Place : std::uint8_t { counting, counting_deltas, vertices, slots, indices, targets, deltas, done };

  Place place = Place::counting;
  std::uint32_t at = 0, run = 0;  // index in the current pass; the run, while vertices are written
  TargetsInWork targets, deltas;
  std::uint32_t block_count = 0, record_count = 0, delta_count = 0;  // of targets, and of examples
  float box_min[3], box_max[3];
  float *skin, *normals, *tangents, *residual, *multi_weights, *uvs;  // where the next vertices go
  std::uint8_t* colours;
  Run* runs;
  std::uint16_t* sets;
};

// Goes on writing a GEOM section (docs/format.md) to `out`, 16-byte aligned, and its size to `bytes`, from streams that
// arrange_geometry() has arranged, until `left` is used up or work.place is `done`. Returns null, or the rule that is
// broken. Cost: a pass over each stream.
const char* write_geometry(const MeshStreams& mesh, const Arrangement& arrangement, WritingInWork& work,
                           Span<std::byte> out, std::uint32_t& bytes, std::uint32_t& left);
// All at once.
const char* write_geometry(const MeshStreams& mesh, const Arrangement& arrangement, Span<std::byte> out,
                           std::uint32_t& bytes);

}  // namespace marrow
