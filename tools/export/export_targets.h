// Morph targets of a geometry as glTF's: a change a vertex.
#pragma once

#include "export/glb.h"
#include "marrow/file.h"

namespace marrow::tools {

// The `targets` of a primitive, all with the same attributes.
Json export_targets(Glb& glb, const Geometry& geometry);

// `count` targets that move nothing, for a primitive beside others that move. positions: its accessor.
Json still_targets(Glb& glb, std::size_t positions, std::size_t count);

}  // namespace marrow::tools
