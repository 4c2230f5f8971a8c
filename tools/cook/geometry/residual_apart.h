// Animation space's residual as bits of its own beside the streams of linear blend skinning.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

struct PackedApart {
  OwnedStreams streams;            // linear blend skinning's with the residual's bits, as the codec gives them back
  std::vector<std::byte> encoded;  // what the codec made of them
};

// encode: as encode_draco(). `streams`, welded, then are in its order, and where they come of smoothing alone their
// residual may have gone a step towards the guess. Returns nothing, and changes nothing, where a residual cannot be
// apart: without one; beside multi-weights; where no vertex follows two joints; and where vertices differ in it alone.
std::optional<PackedApart> pack_apart(OwnedStreams& streams, const ResidualSource& source,
                                      const std::function<std::vector<std::byte>(OwnedStreams&)>& encode);

}  // namespace marrow::cook
