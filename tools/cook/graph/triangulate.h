// Delaunay triangles over points of a plane.
#pragma once

#include <vector>

#include "marrow/blend_space.h"

namespace marrow::cook {

// Counter-clockwise; they cover the points' convex hull. Of points on one circle any diagonals. Empty where two points
// are at one place, or all are on a line. Points: a sweep by x, then flips (C. Lawson, Software for C1 surface
// interpolation, 1977).
std::vector<PlaneTriangle> triangulate(const std::vector<PlanePoint>& points);

}  // namespace marrow::cook
