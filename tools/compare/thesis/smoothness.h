// What the thesis judges algorithms by: how smooth a surface stays where joints meet, and what a rigger has to give.
#pragma once

#include <string>

#include "compare/measure.h"
#include "compare/study.h"
#include "compare/surface_look.h"

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

// What a rigger has to give for an algorithm, in numbers, files and poses.
struct Labour {
  double numbers_per_vertex = 0;  // that somebody paints or sets
  std::size_t files = 0;          // beside the model
  std::size_t poses = 0;          // that somebody shapes; 0 also where they are learnt from another deformer
  std::string of_what;            // those numbers are
};

// deformer: a row of compare, or a truth. An algorithm that learns takes its poses from the model's clips and its
// shapes from the truth, so that nobody shapes them; with --truth examples somebody has.
Labour labour_of(const std::string& deformer, const Study& study, std::size_t shown_poses);

}  // namespace marrow::tools
