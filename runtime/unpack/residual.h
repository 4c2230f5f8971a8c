// Animation space's residual where a record has it apart from the codec's streams (docs/format.md, "Residuals
// apart").
#pragma once

#include "core/byte_reader.h"
#include "core/memory.h"
#include "unpack/residual_codec.h"
#include "unpack/streams.h"

namespace marrow {

// Reads what stands in front of the bits. False for what is out of range.
bool read_residual_apart(ByteReader& reader, MeshStreams& mesh);

// Bytes that it takes. kept: until the mesh is written. freed: only until the mesh is arranged.
struct ResidualBytes {
  std::uint64_t kept, freed;
};
ResidualBytes residual_apart_bytes(const MeshStreams& mesh);

inline constexpr std::uint32_t kResidualBits = packed::kMaxValueBits;

// The state of a residual between its bits and its streams. Neither it nor what it points at may be moved.
struct ResidualInWork {
  enum class Place : std::uint8_t { neighbours, smoothing, decoding, guessing, spreading, done };

  MeshStreams mesh;  // linear blend skinning's
  MeshNeighbours near;
  Smoothed smoothed;
  ResidualTable table;
  std::int32_t* weights = nullptr;  // influences - 1 a vertex, as those of a stream
  std::size_t kept_end = 0;         // where the memory that is kept ends
  Place place = Place::neighbours;
  std::uint32_t at = 0;  // vertex
  NeighboursInWork finding;
  ResidualModels* models = nullptr;
  SymbolDecoder decoder{{}};
};

// Finds the neighbours in work.mesh, and begins to smooth it. Returns null, or the rule that is broken.
const char* begin_guess(Memory& memory, ResidualInWork& work);
// Subtracts the guess from all vertices' residuals (sign -1) or adds it (sign 1), in place, in whole steps. Smoothing
// must be complete. False if a number then needs more than kResidualBits.
bool shift_by_guess(const ResidualInWork& work, std::int32_t sign);
// The same of vertices from `from` on and before `end`.
bool shift_by_guess(const ResidualInWork& work, std::int32_t sign, std::uint32_t from, std::uint32_t end);

// For streams that a codec has decoded. Returns null, or the rule that is broken.
const char* begin_residual_apart(const MeshStreams& mesh, Memory& memory, ResidualInWork*& out);
// Does the next step. The last one gives the mesh its joints, weights and residual; then `done` is true, and `memory`
// holds only what is kept.
const char* unpack_residual_apart(ResidualInWork& work, Memory& memory, MeshStreams& mesh, bool& done);

}  // namespace marrow
