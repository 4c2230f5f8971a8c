// What surfaces look like.
#pragma once

#include <map>
#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "cook/gltf/rules/material_textures.h"
#include "cook/scene/raw.h"

namespace marrow::cook::gltf {

// The document's materials, by its numbering; textures name images by theirs: of a texture with pictures in several
// formats the one that is best for a GPU. `looks` has the root's materials,
// textures, samplers and images, which have been through check_schema().
struct Materials {
  std::vector<RawMaterial> raw;
  std::vector<UvMapping> uvs;  // of the base colour; without one, of the first texture that there is
  // By image, of those that an extension of a texture names: what they are by it, and which image the texture itself
  // has, kNone without.
  struct Alternative {
    ImageFormat format = ImageFormat::unknown;
    int fallback = kNone;
  };
  std::map<std::size_t, Alternative> alternatives;
};
Materials import_materials(const Json& looks, Report& report);

}  // namespace marrow::cook::gltf
