// Materials that are drawn become records that meshes share, and so do their images. What a mesh says itself (name,
// base colour, sides) needs no record.
#pragma once

#include <cstdint>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct BuiltLooks {
  std::vector<std::uint32_t> sections;   // of each mesh: as BuiltMesh::material_section
  std::vector<BuiltMaterial> materials;  // no two the same
  std::vector<RawImage> images;          // no two the same
};

// Notes images that are known by name alone.
BuiltLooks build_materials(const RawScene& scene, const std::vector<BuiltMesh>& meshes, Images images, Notes& notes);

}  // namespace marrow::cook
