// What surfaces look like: materials, where their textures stand in the JSON, and where on their images the texture
// coordinates point.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "cook/scene/raw.h"
#include "marrow/file.h"

namespace marrow::cook::gltf {

// Which coordinates a texture is read at: a set of the primitive's, through KHR_texture_transform.
struct UvMapping {
  std::size_t set = 0;
  double offset[2] = {0, 0};
  double rotation = 0;  // radians
  double scale[2] = {1, 1};

  bool operator==(const UvMapping&) const = default;
  // Offset · rotation · scale. Its example (the lower left quadrant, turned clockwise) settles the sign of the
  // rotation, on which the extension's text and its GLSL differ.
  glm::vec2 apply(glm::vec2 uv) const;
};

// Of a textureInfo object.
UvMapping read_uv_mapping(const Json& info);

// An object of a material below `name`, or one without members. Extensions: below "extensions".
const Json& below(const Json& object, const char* name);

// Calls visit(role, textureInfo, its JSON pointer below the material's) for every texture of a material in the order of
// TextureRole. KHR_materials_pbrSpecularGlossiness fills in what the material's metallic-roughness does not say.
template <class Visit>
void for_each_texture(const Json& material, const Visit& visit) {
  const auto look = [&](TextureRole role, const Json& object, const char* name, const std::string& where) {
    const auto info = object.find(name);
    if (info != object.end()) visit(role, *info, under(where, name));
    return info != object.end();
  };
  const std::string in_metallic = "/pbrMetallicRoughness",
                    in_specular = "/extensions/KHR_materials_pbrSpecularGlossiness";
  const Json& metallic = below(material, "pbrMetallicRoughness");
  const Json& specular = below(below(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
  if (!look(TextureRole::base_colour, metallic, "baseColorTexture", in_metallic))
    look(TextureRole::base_colour, specular, "diffuseTexture", in_specular);
  const bool is_metallic = look(TextureRole::metallic_roughness, metallic, "metallicRoughnessTexture", in_metallic);
  look(TextureRole::normal, material, "normalTexture", "");
  look(TextureRole::occlusion, material, "occlusionTexture", "");
  look(TextureRole::emissive, material, "emissiveTexture", "");
  if (!is_metallic) look(TextureRole::specular_glossiness, specular, "specularGlossinessTexture", in_specular);
}

// The document's materials, by its numbering; textures name images by theirs: of a texture with pictures in several
// formats the one that is best for a GPU. `looks` has the root's materials, textures, samplers and images, which have
// been through check_schema().
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

// A primitive has the coordinates that its material reads. `root` has been through check_schema().
void check_texture_coordinates(const Json& root, Report& report);

}  // namespace marrow::cook::gltf
