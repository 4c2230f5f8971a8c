// Bounds in packed files (docs/format.md) → their sections.
#pragma once

#include "core/byte_reader.h"
#include "unpack/clip/bounds_codec.h"

namespace marrow {

// How large the section of a compact record is, by the counts that it states; 0 if they are out of range, or more than
// its bytes can say.
std::uint64_t measure_bounds_record(Span<const std::byte> record);

// A section on its way: what decodes it, and which of its codes comes next.
struct BoundsInWork {
  explicit BoundsInWork(Span<const std::byte> record);

  SymbolDecoder decoder;
  BoundsCodec<SymbolDecoder> codec;
  std::uint32_t next = 0, back = 0;  // back: how many codes lie between one and what it is guessed from, and one
};

// Goes on writing a section at `out`, 4-byte aligned, and says how long it is. Returns null, or the rule that is
// broken.
const char* unpack_bounds(Span<const std::byte> record, BoundsInWork& work, Span<std::byte> out, std::uint32_t& bytes,
                          bool& done);
inline const char* unpack_bounds(Span<const std::byte> record, Span<std::byte> out, std::uint32_t& bytes) {
  BoundsInWork work(record);
  const char* rule = nullptr;
  for (bool done = false; !done && rule == nullptr;) rule = unpack_bounds(record, work, out, bytes, done);
  return rule;
}

}  // namespace marrow
