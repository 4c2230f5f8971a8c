// Unpack: what a game ships → what load() reads.
//
// A packed file holds its meshes and coded clips compressed. Unpacking yields the cooked file that `marrow cook
// --mesh-codec none` would have written, except for what quantisation lost. The codecs are libraries of their own, so
// that a game links only the one it ships with: draco_decoder() (smallest), meshopt_decoder() (fastest).
#pragma once

#include "marrow/api.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

struct MeshStreams;

// One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
struct MeshDecoder {
  std::uint32_t codec = 0;  // as packed files name it
  // Decompresses the bytes of one mesh into the streams.
  Status (*decode)(Span<const std::byte> bytes, const MeshStreams& out) = nullptr;
};

// Bytes of Unpacking's state.
inline constexpr std::size_t kUnpackStateBytes = 512;

// How much memory unpack() takes.
struct UnpackSizes {
  std::uint32_t file_bytes = 0;    // of the unpacked file
  std::uint32_t memory_bytes = 0;  // what unpack() wants: the file and, behind it, room to work in
};

// Whether these are the first bytes of a packed file. If not, hand them to load().
MARROW_API bool is_packed(Span<const std::byte> bytes);

// How much memory unpacking takes, computed from the counts in the records. A mesh's counts are only what the file
// claims: with some codecs, few bytes can really hold many vertices. So set a limit of your own for files from
// untrusted sources. Errors: bad_magic, bad_version, bad_checksum, truncated; bad_data, also if the header claims any
// other size, or if a clip or bounds claim more than their bytes can hold. Cost: the checksum.
MARROW_API Status unpack_sizes(Span<const std::byte> packed, UnpackSizes& out, DataError* error = nullptr);

// Unpacks into `memory` (16-byte aligned, at least memory_bytes). `file` becomes the front part of memory. Unpacking
// does not check it: load() does, decoded counts, indices and joints included. What lies behind `file` is free again.
//
// packed may come from anywhere: nothing is read outside of it or written outside of memory. Errors: as unpack_sizes();
// bad_data; unsupported if a mesh's codec is not among `decoders` (DataError::rule names it); out_of_memory, by Draco;
// bad_argument. On failure `file` is unchanged and memory holds garbage. Vertices come out grouped and ordered for
// skinning, triangles in the order of the codec. Thread-safe on different outputs. Cost: docs/benchmarks.md; Draco
// allocates while it decodes, nothing else does.
MARROW_API Status unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
                         Span<const std::byte>& file, DataError* error = nullptr);

// The same in steps, for a game that loads while it plays: as many a frame as its time allows.
//
//   once          begin_unpack()
//   every frame   unpack_step(), while there is time and Unpacking::file is empty
//   then          load() of Unpacking::file
//
// A plain struct; a new one has not begun. Keep the packed bytes, the decoders and the memory as they are until the
// last step. To stop half way, just forget the struct: there is nothing to free.
struct Unpacking {
  Span<const std::byte> file = {};                     // empty until the last step is done; then as of unpack()
  std::uint32_t done_bytes = 0;                        // of total_bytes; for a progress bar
  std::uint32_t total_bytes = 0;                       // of the unpacked file
  alignas(8) std::byte state[kUnpackStateBytes] = {};  // unpack_step()'s own
};

// Checks the header and the records' counts. Errors: as unpack_sizes(), and bad_argument; then nothing is begun.
// Cost: the checksum.
MARROW_API Status begin_unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
                               Unpacking& out, DataError* error = nullptr);

// Does one step: a record, or one stage of a mesh (decode; smooth and decode the residual of animation space, if there
// is one; order; write). After the records it does the file's checksum. A step ends early once it has done a few
// milliseconds' work, and the next step goes on there. Only a single call of a codec's library cannot be cut. A call of
// meshoptimizer decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them. A call of
// Draco decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
//
// Errors: as unpack(), and unpacking has then ended; bad_argument if none had begun. May run on any thread, on one at a
// time.
MARROW_API Status unpack_step(Unpacking& unpacking, DataError* error = nullptr);

}  // namespace marrow
