// Animation space's residual where a record has it apart from the codec's streams (docs/packed_format.md, "Residuals
// apart").
#pragma once

#include "core/byte_reader.h"
#include "core/memory.h"
#include "unpack/residual_codec.h"
#include "unpack/streams.h"

namespace marrow {

// Reads what stands in front of the bits. False for what is out of range.
bool read_residual_apart(ByteReader& reader, MeshStreams& mesh);

// Bytes that it takes: of what stays until the mesh is written, and of what is free again before it is arranged.
struct ResidualBytes {
  std::uint64_t kept, freed;
};
ResidualBytes residual_apart_bytes(const MeshStreams& mesh);

inline constexpr std::uint32_t kResidualBits = packed::kMaxValueBits;

// A residual on its way from its bits to streams. What it points at, and it, lie where nothing moves them.
struct ResidualInWork {
  enum class Place : std::uint8_t { neighbours, smoothing, decoding, guessing, spreading, done };

  MeshStreams mesh;  // linear blend skinning's
  MeshNeighbours near;
  Smoothed smoothed;
  ResidualTable table;
  std::int32_t* weights = nullptr;  // influences - 1 a vertex, as those of a stream
  std::size_t kept_end = 0;         // of the memory
  Place place = Place::neighbours;
  std::uint32_t at = 0;  // vertex
  NeighboursInWork finding;
  ResidualModels* models = nullptr;
  SymbolDecoder decoder{{}};
};

// Looks who is whose neighbour in work.mesh, and begins to smooth it. Returns null, or the rule that is broken.
const char* begin_guess(Memory& memory, ResidualInWork& work);
// Between residuals in whole steps and how far they are from the guess, in place, when all is smoothed: takes the guess
// (sign -1) from all vertices' numbers, or adds it (1). False if a number then needs more than kResidualBits.
bool shift_by_guess(const ResidualInWork& work, std::int32_t sign);
// The same of vertices from `from` on and before `end`.
bool shift_by_guess(const ResidualInWork& work, std::int32_t sign, std::uint32_t from, std::uint32_t end);

// For streams that a codec has decoded. Returns null, or the rule that is broken.
const char* begin_residual_apart(const MeshStreams& mesh, Memory& memory, ResidualInWork*& out);
// Goes on with the next step. The last one gives the mesh its joints, weights and residual. Then `done`, and `memory`
// is back at what stays.
const char* unpack_residual_apart(ResidualInWork& work, Memory& memory, MeshStreams& mesh, bool& done);

}  // namespace marrow
