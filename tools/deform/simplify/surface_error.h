// How far a simpler surface is from the one that it was made of, over poses, and a few poses that stand for many.
#pragma once

#include <cstddef>
#include <vector>

#include "deform/simplify/simplify.h"
#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Representative {
  std::size_t pose;  // which of those given
  double weight;     // the share of poses that are most like it
};

// Up to `most` poses, `first` among them, each the least like those before it, by distances between a few hundred pairs
// of vertices: so it does not matter where a character stands and which way it looks. Weights sum to 1. The same on
// every run. Fewer where poses do not differ.
std::vector<Representative> representative_poses(const Deformer& deformer, const std::vector<Pose>& poses,
                                                 std::size_t first, std::size_t most);

// Where a point of the source lies on the simpler surface.
struct Anchor {
  std::uint32_t points[3];
  double shares[3];
};

// For each point that a triangle uses the nearest of the simpler surface, over all shapes at once, on the triangles of
// the point that has become of it and of that one's neighbours. `simpler`: where its points are in the same shapes.
std::vector<Anchor> anchor(const SimplerSurface& surface, const std::vector<Shape>& shapes,
                           const std::vector<Shape>& simpler);

struct SurfaceError {
  double rms = 0, worst = 0;  // over points, each counted alike, and poses
};
// Between points and their anchors. Poses in which either is not finite are left out.
SurfaceError surface_error(const Deformer& source, const Deformer& simpler, const std::vector<Anchor>& anchors,
                           const std::vector<std::uint32_t>& home, const std::vector<Pose>& poses);

}  // namespace marrow::deform
