// Joints and weights apart from the streams that a codec takes (docs/format.md, "Skins apart").
#pragma once

#include <optional>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

class SkinApart {
 public:
  // Takes them out of the streams. Nothing, and nothing is changed, where there are none that bits can say, and where
  // vertices differ in them alone.
  static std::optional<SkinApart> take(OwnedStreams& streams);

  // Puts them back, when a codec has ordered the vertices, of which it may have made more. Returns the bits.
  std::vector<std::byte> give_back(OwnedStreams& streams) const;

 private:
  OwnedStreams before_;
};

}  // namespace marrow::cook
