// Meshes whose morph targets clips may weigh.
#pragma once

#include <vector>

#include "cook/scene/built.h"

namespace marrow::cook {

// Those of a file, which outlives what is returned, in full detail. What their targets have been rounded by is not
// known.
std::vector<MorphedMesh> morphed_meshes(const File& file);
// Of `meshes` and their geometries, which outlive it.
std::vector<MorphedMesh> morphed_meshes(const std::vector<BuiltMesh>& meshes,
                                        const std::vector<BuiltGeometry>& geometries);

}  // namespace marrow::cook
