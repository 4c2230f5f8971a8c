// EigenSkin with one basis for the whole mesh, as morph targets that clips drive: Kry, James, Pai, "EigenSkin: real
// time large deformation character skinning in hardware", SCA 2002.
#pragma once

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with `options.eigen_targets` morph targets more in every mesh that a skin moves: the principal components
// of what linear blend skinning misses of the truth, taken back to the bind pose, in up to 320 moments of the clips.
// Each clip gets their weights 30 times a second, by least squares: v' = SSD(v + Σ_n c_n(t) u_n). Normals stay. A mesh
// that is drawn several times is copied. Meshes that no clip moves, or that the truth leaves as they are, get none; if
// none gets any, that is noted. Notes how far a mesh was off and is now, in the root of the mean square over vertices
// and moments. Cost: a truth a moment and vertex, and for the components O(moments² · vertices); 24 bytes · vertices ·
// moments. Throws tools::Failure: unsupported for a mesh that is too large.
RawScene add_eigen_targets(RawScene scene, const LearnOptions& options, Notes& notes);

}  // namespace marrow::cook
