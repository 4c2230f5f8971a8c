// Unpack: what a game ships → what load() reads.
//
// A packed file holds its meshes and coded clips compressed. Unpacking it yields a cooked file as `marrow cook
// --mesh-codec none` would have written it, but for what quantisation took. The codecs are libraries of their own, so
// that a game links only the one it ships with: draco_decoder() (smallest), meshopt_decoder() (fastest).
#pragma once

#include "marrow/api.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

struct MeshStreams;

// One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
struct MeshDecoder {
  std::uint32_t codec = 0;                                                          // as packed files name it
  Status (*decode)(Span<const std::byte> bytes, const MeshStreams& out) = nullptr;  // the codec
};

// Bytes of Unpacking's state.
inline constexpr std::size_t kUnpackStateBytes = 512;

// How much memory unpack() takes.
struct UnpackSizes {
  std::uint32_t file_bytes = 0;    // of the unpacked file
  std::uint32_t memory_bytes = 0;  // what unpack() wants: the file and, behind it, room to work in
};

// Whether these are the first bytes of a packed file. Anything else is for load() to judge.
MARROW_API bool is_packed(Span<const std::byte> bytes);

// How much memory unpacking takes: what the records need by their counts, and bad_data if the header claims anything
// else, or a clip or bounds more than their bytes can hold. A mesh's counts are the file's claim, which a codec's few
// bytes may bear out, so whoever reads files of strangers should set a limit. Errors: bad_magic, bad_version,
// bad_checksum, truncated, bad_data. Cost: the checksum.
MARROW_API Status unpack_sizes(Span<const std::byte> packed, UnpackSizes& out, DataError* error = nullptr);

// Unpacks into `memory` (16-byte aligned, at least memory_bytes) and makes `file` its front part, which is for load()
// to check, the decoded counts, indices and joints with it. What lies behind `file` is free again.
//
// packed may come from anywhere: nothing is read outside of it or written outside of memory. Errors: as unpack_sizes();
// bad_data; unsupported if a mesh's codec is not among `decoders` (DataError::rule names it); out_of_memory, by Draco;
// bad_argument. On failure
// `file` is unchanged and memory holds garbage. Vertices come out grouped and ordered for skinning, triangles in the
// order of the codec. Thread-safe on different outputs. Cost: docs/benchmarks.md; Draco allocates while it decodes,
// nothing else does.
MARROW_API Status unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
                         Span<const std::byte>& file, DataError* error = nullptr);

// The same in steps, for a game that loads while it plays: as many a frame as its time allows.
//
//   once          begin_unpack()
//   every frame   unpack_step(), while there is time and Unpacking::file is empty
//   then          load() of Unpacking::file
//
// A plain struct; a new one has nothing begun. The packed bytes, the decoders and the memory stay as they are until
// the last step. Stopping half way is forgetting it: nothing is to be freed.
struct Unpacking {
  Span<const std::byte> file = {};                     // empty until the last step is done; then as of unpack()
  std::uint32_t done_bytes = 0;                        // of total_bytes, for a bar
  std::uint32_t total_bytes = 0;                       // of the unpacked file
  alignas(8) std::byte state[kUnpackStateBytes] = {};  // unpack_step()'s own
};

// Checks the header and the records' counts. Errors: as unpack_sizes(), and bad_argument; then nothing is begun.
// Cost: the checksum.
MARROW_API Status begin_unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
                               Unpacking& out, DataError* error = nullptr);

// Goes on with one record, or with one of a mesh's stages: decoding, where animation space has a residual smoothing it
// and decoding that, ordering and writing; then with the file's checksum. A step stops when it has done so much, a few
// milliseconds whatever the file holds, and the next one goes on there; but for what a codec's library does in one
// call. meshoptimizer's decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them.
// Draco's decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
//
// Errors: as unpack(); nothing is in work afterwards. bad_argument: nothing is in work. May run on any thread, on one
// at a time.
MARROW_API Status unpack_step(Unpacking& unpacking, DataError* error = nullptr);

}  // namespace marrow
