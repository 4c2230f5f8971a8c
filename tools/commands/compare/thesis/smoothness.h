// How smooth a surface stays where joints meet.
#pragma once

#include "commands/compare/hinges.h"
#include "commands/compare/measure.h"

namespace marrow::tools {

// Means over poses, where joints meet: at edges with a vertex that follows two joints or more.
struct Smoothness {
  double largest_jump_deg = 0;  // between the normals of the two triangles at an edge, beyond the bind pose's
  double rms_jump_deg = 0;      // the same over all such edges
  double curvature = 0;         // the root mean square of the mean curvature, over the bind pose's
};

// Of poses of one kind of the range of motion; zeros if there is none. shape: of the study's mesh.
Smoothness smoothness(const Shape& shape, const deform::RangeOfMotion& motion, bool twists,
                      const deform::Deformer& deform);

// The mean curvature at each vertex, a metre: half the length of the cotangent Laplacian of the positions (Meyer,
// Desbrun, Schröder and Barr, "Discrete differential-geometry operators for triangulated 2-manifolds", 2003), with a
// third of its triangles' area each. 0 where they have none.
std::vector<double> mean_curvatures(const deform::Positions& positions, const std::vector<std::uint32_t>& indices);

}  // namespace marrow::tools
