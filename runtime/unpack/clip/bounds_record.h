// Bounds in packed files (docs/packed_format.md) → their sections.
#pragma once

#include "core/byte_reader.h"

namespace marrow {

// How large the section of a compact record is, by the counts that it states; 0 if they are out of range.
std::uint64_t measure_bounds_record(Span<const std::byte> record);

// Writes a section at `out`, 4-byte aligned, and says how long it is. Returns null, or the rule that is broken.
const char* unpack_bounds(Span<const std::byte> record, Span<std::byte> out, std::uint32_t& bytes);

}  // namespace marrow
