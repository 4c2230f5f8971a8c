// What Draco data claims to hold, before anything is allocated for it.
#pragma once

#include <cstdint>

#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

struct DracoCounts {
  std::uint64_t points = 0;  // of edgebreaker data vertices, of which seams make more points
  std::uint64_t faces = 0;
  std::uint32_t seams = 0;  // of edgebreaker data, how many properties have seams of their own: each takes a table
  bool edgebreaker = false;
};

// Reads the counts at the start of a triangle mesh: a few bytes can claim billions. Metadata before them is passed
// over. Nothing here is trusted: the counts are to be compared again after decoding. Errors: unsupported for any
// bitstream but version 2.2, which glTF names and all encoders since 2018 write; bad_magic; bad_data; truncated. Cost:
// the metadata's bytes.
Status draco_counts(Span<const std::byte> bytes, DracoCounts& out);

}  // namespace marrow
