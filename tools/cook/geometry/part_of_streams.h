// A part of a mesh's streams.
#pragma once

#include <cstdint>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// Some vertices, ascending, some triangles of those, and the palette entries that they need, ascending. Numbers stay
// what they are, so that parts agree to the bit where they meet. Precondition: streams that are not welded.
OwnedStreams part_of_streams(const OwnedStreams& whole, const std::vector<std::uint32_t>& vertices,
                             const std::vector<std::uint32_t>& indices, const std::vector<std::uint16_t>& entries);

}  // namespace marrow::cook
