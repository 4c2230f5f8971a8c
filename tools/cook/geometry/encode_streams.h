// Streams → the bytes that a codec of the runtime turns back into them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// What Draco's ways to predict are chosen for: bytes alone, or bytes as far as they do not make decoding slow.
enum class DracoAim { quick, smallest };

// Draco's edgebreaker, with each stream predicted in the way that serves the aim best. It reorders vertices and
// triangles, and may split vertices where the surface is no manifold: `streams` becomes what decoding yields. Throws
// tools::Failure (internal) if that is not the same surface.
std::vector<std::byte> encode_draco(OwnedStreams& streams, DracoAim aim);

// meshoptimizer's codecs; vertices are put into the order in which the runtime will store them.
std::vector<std::byte> encode_meshopt(OwnedStreams& streams);

// Joints and weights apart from the streams that a codec takes (docs/format.md, "Skins apart").
class SkinApart {
 public:
  // Takes them out of the streams. Returns nothing, and changes nothing, where there are none that fit the coder, or
  // where vertices differ in them alone.
  static std::optional<SkinApart> take(OwnedStreams& streams);

  // Puts them back, when a codec has ordered the vertices, of which it may have made more. Returns the bits.
  std::vector<std::byte> give_back(OwnedStreams& streams) const;

 private:
  OwnedStreams before_;
};

// Animation space's residual as bits of its own beside the streams of linear blend skinning.
struct PackedApart {
  OwnedStreams streams;            // linear blend skinning's with the residual's bits, as the codec gives them back
  std::vector<std::byte> encoded;  // what the codec made of them
};

// encode: as encode_draco(). `streams` must be welded; afterwards they are in the codec's order, and a residual that
// comes of smoothing alone may have gone a step towards the guess. Returns nothing, and changes nothing, where a
// residual cannot be apart: without one; beside multi-weights; where no vertex follows two joints; and where vertices
// differ in it alone.
std::optional<PackedApart> pack_apart(OwnedStreams& streams, const ResidualSource& source,
                                      const std::function<std::vector<std::byte>(OwnedStreams&)>& encode);

}  // namespace marrow::cook
