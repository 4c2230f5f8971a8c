// What Draco data claims to hold, before anything is allocated for it.
#pragma once

#include <cstdint>

#include "marrow/span.h"

namespace marrow {

// Whether the counts at the start of a triangle mesh exceed what is promised elsewhere: a few bytes can claim billions.
// Reads version 2.2 of the bitstream, the only one that current encoders write, without metadata; of other data it
// knows nothing and returns false. Nothing here is trusted: the counts are to be compared again after decoding.
bool draco_claims_more(Span<const std::byte> bytes, std::uint64_t points, std::uint64_t faces);

}  // namespace marrow
