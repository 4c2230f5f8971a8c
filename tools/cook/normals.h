// Normals for meshes that come without.
#pragma once

#include "cook/raw.h"

namespace marrow::cook {

// Sets primitive.normals: each vertex's triangles' normals, weighted by the angle at the vertex (Thürmer and Wüthrich,
// 1998). Flat where vertices are not shared, as glTF asks; smooth where they are. A vertex without area gets +Y.
// Tangents, which glTF says to ignore then, are dropped.
void generate_normals(RawPrimitive& primitive);

// Sets the targets' normals to those that generate_normals() gives their shapes; of a primitive whose own it made.
void generate_target_normals(RawPrimitive& primitive);

}  // namespace marrow::cook
