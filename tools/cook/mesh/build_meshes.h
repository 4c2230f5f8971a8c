// Which geometries there are, and which joints each mesh binds them to.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct BuiltMeshes {
  std::vector<BuiltGeometry> geometries;  // no two the same
  std::vector<LearnReport> learnt;
  std::vector<BuiltMesh> meshes;  // node by node, primitive by primitive, part by part; without materials' sections
};

// Points into `built`, without levels of detail.
std::vector<Mesh> full_meshes(const BuiltMeshes& built);
// With levels of detail: each once that moves otherwise than those before it.
std::vector<Mesh> distinct_views(const BuiltMeshes& built);

// built: its skeletons and clips. Throws tools::Failure as bind_meshes() and build_geometry(), at the primitive.
BuiltMeshes build_meshes(const RawScene& scene, const BuiltScene& built, const MeshOptions& options,
                         const LearnOptions& learn, Notes& notes);

}  // namespace marrow::cook
