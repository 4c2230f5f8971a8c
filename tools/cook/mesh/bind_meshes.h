// Meshes as they are drawn: bound to skins, learnt from their poses, subdivided and split.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "cook/skin/skin_binding.h"

namespace marrow::cook {

// A mesh and a skin that moves it.
using MeshOnSkin = std::pair<int, int>;

struct BoundMeshes {
  std::map<MeshOnSkin, SkinBinding> bindings;
  std::vector<LearnReport> learnt;  // see SkinBinding::report
  std::map<int, RawMesh> finer;     // in the place of the scene's
  const RawMesh& mesh(const RawScene& scene, int number) const;
};

// Whether the primitive moves with the instance's skin.
bool is_skinned(const RawInstance& instance, const RawPrimitive& primitive);

// One grid for all primitives of a mesh, so that where they touch they still do. scene_scale: see SceneScale.
MeshGrid mesh_grid(const RawMesh& mesh, double scene_scale, const MeshOptions& options);

// Each once, in the order of instances.
std::vector<MeshOnSkin> skinned_meshes(const RawScene& scene);

// Learns for one of skinned_meshes() what bind_meshes() would, into `notes.host->fits`.
void learn_ahead(const RawScene& scene, const BuiltScene& built, MeshOnSkin which, const LearnOptions& learn,
                 Notes& notes);

// built: its skeletons and clips. Throws tools::Failure: unsupported for what needs too large a palette, invalid for
// examples that do not fit.
BoundMeshes bind_meshes(const RawScene& scene, const BuiltScene& built, const MeshOptions& options,
                        const LearnOptions& learn, Notes& notes);

}  // namespace marrow::cook
