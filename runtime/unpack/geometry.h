// A packed geometry: a short header, the numbers that undo quantisation, and what the codec made of the streams.
#pragma once

#include "core/byte_reader.h"
#include "core/memory.h"
#include "marrow/unpack.h"
#include "unpack/expand.h"
#include "unpack/streams.h"

namespace marrow {

struct ResidualInWork;

// How many streams there are at most.
constexpr std::uint64_t geometry_stream_count(std::uint64_t target_count, std::uint64_t example_count) {
  return kBindStreams + 3 * target_count + example_count;
}

// Reads what stands in front of the codec's bytes; takes memory for the streams, whose arrays are left null. Returns
// null, or the rule that is broken.
const char* read_geometry_record(ByteReader& reader, Memory& memory, MeshStreams& out);

// What a record will need, by the counts that it states.
struct GeometryNeeds {
  std::uint64_t scratch_bytes;       // as geometry_scratch_bytes()
  std::uint64_t most_section_bytes;  // how many depends on which joints vertices share
};
// Needs no memory. Returns null, or the rule that is broken.
const char* measure_geometry_record(Span<const std::byte> record, GeometryNeeds& out);

// Bytes of scratch memory for the arrays of these streams and for expanding them.
std::uint64_t geometry_scratch_bytes(const MeshStreams& mesh);

// The state of a mesh between its record and its section. What it points at lies in the scratch memory.
struct GeometryInWork {
  Memory scratch;
  MeshStreams streams;
  Decoding decoding;
  ResidualInWork* residual = nullptr;  // begun
  ArrangingInWork arranging;
  Arrangement arrangement;
  WritingInWork* writing = nullptr;  // begun
};

// Decodes a record's streams. finish_streams(), arrange_geometry() and write_geometry() follow, each until it is done.
// Returns null, or the rule that is broken; `decoded` is the codec's status. With `done` a call does one step, if the
// codec can stop; without `done` it does everything. `out` is {} at first.
const char* decode_geometry(Span<const std::byte> record, const MeshDecoder& decoder, Span<std::byte> scratch,
                            GeometryInWork& out, Status& decoded, bool* done = nullptr);

// Does the next step of a residual apart (unpack/residual.h); a mesh without one has nothing to do. Returns null, or
// the rule that is broken.
const char* finish_streams(GeometryInWork& mesh, bool& done);

// One step of arrange_geometry() and of write_geometry(), likewise.
const char* arrange_geometry(GeometryInWork& mesh, bool& done);
const char* write_geometry(GeometryInWork& mesh, Span<std::byte> out, std::uint32_t& bytes, bool& done);

// All in one go, for the cooker and for tests.
inline const char* unpack_geometry(Span<const std::byte> record, const MeshDecoder& decoder, Span<std::byte> scratch,
                                   Span<std::byte> out, std::uint32_t& bytes, Status& decoded) {
  GeometryInWork mesh;
  const char* rule = decode_geometry(record, decoder, scratch, mesh, decoded);
  for (bool done = false; rule == nullptr && !done;) rule = finish_streams(mesh, done);
  if (rule == nullptr) rule = arrange_geometry(mesh.streams, mesh.scratch, mesh.arrangement);
  return rule != nullptr ? rule : write_geometry(mesh.streams, mesh.arrangement, out, bytes);
}

}  // namespace marrow
