// Fewer triangles for a surface that moves: edges collapse in the order of what that costs in several shapes at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deform/simplify/combination.h"

namespace marrow::deform {

// Triangles over vertices, vertices at points: those at one point move alike. Vertices of one chart differ in nothing
// but their normals; those of different charts in UVs or material, which is a seam.
struct SeamedSurface {
  std::vector<std::uint32_t> point_of;  // a vertex
  std::vector<std::uint32_t> chart_of;  // a vertex; no two points share a chart
  std::vector<glm::dvec3> normals;      // a vertex; any length
  std::vector<std::uint32_t> indices;   // of vertices, 3 a triangle
};

// Where the points are in one pose, and how much it counts; the first of several is the bind pose.
struct Shape {
  Positions positions;
  double weight = 1;
};

enum class Placement {
  ends,  // a collapsed edge becomes one of its ends
  line,  // or any point between them, where both are within the surface and have one normal
};

struct SimplerSurface {
  std::vector<Combination> vertices;    // of the source's; shares ≥ 0
  std::vector<std::uint32_t> point_of;  // a vertex
  std::vector<std::uint32_t> indices;   // of vertices
  std::vector<std::uint32_t> home;      // a point of the source: which point has become of it; kNoHome: no triangle's
};
inline constexpr std::uint32_t kNoHome = 0xFFFFFFFF;

// A surface for each number of triangles in `targets`, which descend, each made of the one before; with more triangles
// than asked for where no edge is left that may collapse.
//
// The error of a point is the sum of its squared distances from planes, those of the triangles that it stands for in
// each of the shapes (Garland and Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997; over
// poses: Mohr and Gleicher, "Deformation sensitive decimation", 2003), and of planes through borders and seams. A plane
// counts by the root of its triangle's area: where triangles are small, they are so for a reason. As shapes are linear
// in the points' animation-space coordinates, a collapsed edge has the same shares of its ends in all of them. A point
// on a border or a seam goes only along it, onto another; a point where more than two triangles share an edge, or
// several parts of the surface meet, or another point lies in the same place, stays, and so does one with more than 64
// triangles. Where a corner goes to a point
// with several normals it takes the nearest. No triangle of the bind pose turns by more than 78° in a step, none of
// another shape over; the surface's topology stays.
//
// The same result on every run. Cost: n log n in the triangles, times the number of shapes; memory: 104 bytes a point
// and shape.
std::vector<SimplerSurface> simplify(const SeamedSurface& surface, const std::vector<Shape>& shapes,
                                     const std::vector<std::size_t>& targets, Placement placement);

}  // namespace marrow::deform
