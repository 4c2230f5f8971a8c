// Materials and pictures as a file has them. The runtime draws with neither: a game does.
#pragma once

#include <cstdint>

#include "marrow/api.h"
#include "marrow/span.h"

namespace marrow {

// In Mesh::material_index: the source says no more of the material than the Mesh itself holds.
inline constexpr std::uint32_t kNoMaterial = 0xFFFFFFFF;
// How a material's alpha is meant, as in glTF 2.0.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };
// Which property of a material an image supplies.
enum class TextureRole : std::uint8_t {
  base_colour,
  metallic_roughness,
  normal,
  occlusion,
  emissive,
  specular_glossiness  // KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
};
// What lies beyond an image's edge.
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };
// How an image is magnified.
enum class MagFilter : std::uint8_t { any, nearest, linear };  // any: the source leaves it to the game
// How an image is minified; any: the source leaves it to the game.
enum class MinFilter : std::uint8_t {
  any,
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear,
};

// An image in a role; its channels are as in glTF 2.0, section 3.9. Base colour, emissive and specular-glossiness
// images are sRGB (the last except for alpha), all others linear. UV (0, 0) is the image's upper left corner.
struct Texture {
  std::uint16_t image = 0;                            // which image of the file
  TextureRole role = TextureRole::base_colour;        // none twice in a material
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;  // along u and v
  MagFilter mag = MagFilter::any;                     // as the source asks
  MinFilter min = MinFilter::any;                     // as the source asks
  std::uint8_t reserved = 0;
};
static_assert(sizeof(Texture) == 8);

// What a material has beyond the members of Mesh.
struct Material {
  const char* name = "";                // as the source calls it; never null
  AlphaMode alpha = AlphaMode::opaque;  // opaque: alpha is not looked at
  float alpha_cutoff = 0.5f;            // mask: what is less opaque is not drawn
  bool unlit = false;                   // KHR_materials_unlit: the base colour is what is seen
  float emissive[3] = {0, 0, 0};      // linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
  Span<const Texture> textures = {};  // one a role
};

// No image.
inline constexpr std::uint32_t kNoImage = 0xFFFFFFFF;
// What an image's bytes are.
enum class ImageFormat : std::uint8_t { unknown, png, jpeg, webp, ktx2, dds };
// A picture, by reference or as the source's own bytes. Marrow does not check the bytes; whoever decodes them must.
struct Image {
  const char* name = "";  // as the source calls it; never null
  const char* uri = "";   // relative to the source file and percent-encoded, as it stood there; empty if it had none
  ImageFormat format = ImageFormat::unknown;  // unknown: neither its bytes nor its URI tell which
  Span<const std::byte> bytes = {};           // empty: by reference
  std::uint32_t fallback = kNoImage;          // of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
};

}  // namespace marrow
