// A geometry's blocks of four as glTF's accessors: one element a vertex.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "glb/glb.h"
#include "marrow/file.h"

namespace marrow::tools {

// Accessors of what does not depend on the skin: {"attributes": {POSITION, …}, "indices"}. parts: of one primitive.
Json export_vertices(Glb& glb, std::span<const Geometry> parts);

// Which joints of a skin a palette entry follows: of a helper two.
struct EntryJoints {
  std::uint16_t first = 0, second = 0;
  float share = 0;  // of second
  auto operator<=>(const EntryJoints&) const = default;
};

// Adds JOINTS_n and WEIGHTS_n to `attributes`; a helper's weight is its joints', by shares. entries: for each part
// those of its palette; wide: numbers above 255 occur. Each vertex's weights add up to exactly 1 in float, largest
// first.
void export_weights(Glb& glb, std::span<const Geometry> parts, const std::vector<std::vector<EntryJoints>>& entries,
                    bool wide, Json& attributes);

}  // namespace marrow::tools
