// Inverse binds that need not stand in a packed file.
#pragma once

#include <vector>

#include "cook/mesh/build_meshes.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// The meshes with what the runtime derives from the rest pose in the place of their inverse binds, where that moves no
// corner of the mesh's box by more than an eighth of a step of its positions; the geometries' errors grow by as much.
BuiltMeshes derive_inverse_binds(const std::vector<BuiltSkeleton>& skeletons, BuiltMeshes meshes);

}  // namespace marrow::cook
