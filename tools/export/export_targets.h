// Morph targets of a geometry as glTF's: a change a vertex.
#pragma once

#include <span>

#include "glb/glb.h"
#include "marrow/file.h"

namespace marrow::tools {

// The `targets` of a primitive, all with the same attributes. parts: of one primitive; they have as many.
Json export_targets(Glb& glb, std::span<const Geometry> parts);

// `count` targets that move nothing, for a primitive beside others that move. positions: its accessor.
Json still_targets(Glb& glb, std::size_t positions, std::size_t count);

}  // namespace marrow::tools
