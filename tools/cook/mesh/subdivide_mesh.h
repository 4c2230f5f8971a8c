// A mesh with four times the triangles, smoother.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "cook/skin/skin_binding.h"
#include "deform/skinned_mesh.h"

namespace marrow::cook {

// A skin that the mesh is bound to.
struct MovedBy {
  const SkinBinding* binding;                        // without deformers beside animation space
  std::function<std::vector<deform::Pose>()> poses;  // where being close counts; helpers among the joints
};

struct FinerMesh {
  RawMesh mesh;
  std::vector<SkinBinding> bindings;  // a skin, in their order
  std::size_t cut = 0;                // points that follow fewer joints than they would, over all skins
};

// Loop's scheme over all primitives together, so that they stay closed where they touch; see deform::subdivide().
// Vertices are one point if they lie in one place, follow the same joints alike and are moved alike by morph targets.
// - By points: positions, what morph targets add to them, weights of SSD and, where there are residuals, coordinates of
//   animation space, whose residual is what the finer position and weights leave. That is exact but where a point would
//   follow more than kMaxInfluences joints: it gets the closest that so many can do, see with_fewer_joints().
// - Along edges: UVs, colours, tangents, what morph targets add to normals and tangents.
// - Normals: the surface's, area-weighted over the triangles of vertices that have one normal at a point, and what the
//   source's normals had beside that, along edges.
//
// skins: all that the mesh is bound to.
FinerMesh subdivide_mesh(const RawMesh& mesh, const std::vector<MovedBy>& skins, int steps);

}  // namespace marrow::cook
