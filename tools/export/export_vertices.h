// A geometry's blocks of four as glTF's accessors: one element a vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glb/glb.h"
#include "marrow/file.h"

namespace marrow::tools {

// Accessors of what does not depend on the skin: {"attributes": {POSITION, …}, "indices"}. parts: of one primitive.
Json export_vertices(Glb& glb, std::span<const Geometry> parts);

// Adds JOINTS_n and WEIGHTS_n to `attributes`. skin_joints: for each part and palette entry its number in the skin;
// wide: numbers above 255 occur. Each vertex's weights add up to exactly 1 in float, largest first.
void export_weights(Glb& glb, std::span<const Geometry> parts,
                    const std::vector<std::vector<std::uint16_t>>& skin_joints, bool wide, Json& attributes);

}  // namespace marrow::tools
