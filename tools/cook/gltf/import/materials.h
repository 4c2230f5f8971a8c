// What surfaces look like.
#pragma once

#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "cook/gltf/rules/material_textures.h"
#include "cook/scene/raw.h"

namespace marrow::cook::gltf {

// The document's materials, by its numbering; textures name images by theirs. `looks` has the root's materials,
// textures, samplers and images, which have been through check_schema().
struct Materials {
  std::vector<RawMaterial> raw;
  std::vector<UvMapping> uvs;  // of the base colour; without one, of the first texture that there is
};
Materials import_materials(const Json& looks, Report& report);

}  // namespace marrow::cook::gltf
