// More triangles for a surface: Loop's scheme, the converse of simplification.
#pragma once

#include <cstddef>

#include "deform/simplify/simplify.h"

namespace marrow::deform {

struct FinerSurface {
  std::vector<Combination> points;      // of the source's
  std::vector<Combination> vertices;    // of the source's, along edges: for what is not smoothed, such as UVs
  std::vector<std::uint32_t> point_of;  // a vertex
  std::vector<std::uint32_t> indices;   // of vertices; a triangle becomes four
};

// Loop, "Smooth subdivision surfaces based on triangles", 1987, with borders as cubic splines: a point within the
// surface goes to 1 - nβ of itself and β of each neighbour, β = (5/8 - (3/8 + cos(2π/n)/4)²) / n, the middle of an edge
// to 3/8 of its ends and 1/8 of the points opposite; on a border to 3/4 and 1/8 of its two neighbours, and to the
// middle. Points with any other number of border edges, and edges of more than two triangles, count as corners: they
// stay, and their middles are middles. The points of the source come first, in order. Shares sum to 1, so
// animation-space coordinates are subdivided as positions are: subdividing and posing commute. The same result on every
// run.
FinerSurface subdivide(const SeamedSurface& surface, std::size_t point_count);

}  // namespace marrow::deform
