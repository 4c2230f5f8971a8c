// MATL: a material. IMAG: an image.
#pragma once

#include "asset/sections/fields.h"
#include "asset/sections/kind.h"
#include "marrow/file.h"

namespace marrow::format {

enum MaterialFlags : std::uint16_t { kUnlit = 1, kEmits = 2, kAllMaterialFlags = 3 };

struct MaterialHeader {
  std::uint32_t name;
  float alpha_cutoff;
  AlphaMode alpha;
  std::uint8_t texture_count;
  std::uint16_t flags;
};
static_assert(sizeof(MaterialHeader) == 12);

struct MaterialLayout {
  Array<Texture> textures;
  Array<float> emissive;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<MaterialHeader> {
  using Type = MaterialLayout;
};

template <class V>
constexpr void fields(V& v, const Texture& t) {
  constexpr const char *kNoWrap = "unknown wrap mode", *kNoFilter = "unknown filter";
  v.section({"image", "which IMAG section"}, t.image, kImages, "no such image");
  v.range({"role",
           "0 base colour, 1 metallic-roughness, 2 normal, 3 occlusion, 4 emissive, 5 specular-glossiness; none twice "
           "in a material"},
          t.role, TextureRole::base_colour, TextureRole::specular_glossiness, "unknown role of a texture");
  v.range({"wrap_u", "0 repeat, 1 clamp to edge, 2 mirrored repeat"}, t.wrap_u, Wrap::repeat, Wrap::mirrored_repeat,
          kNoWrap);
  v.range({"wrap_v", "as wrap_u"}, t.wrap_v, Wrap::repeat, Wrap::mirrored_repeat, kNoWrap);
  v.range({"mag", "0 not given, 1 nearest, 2 linear"}, t.mag, MagFilter::any, MagFilter::linear, kNoFilter);
  v.range({"min",
           "0 not given, 1 nearest, 2 linear, 3 nearest of the nearest mipmap, 4 linear of the nearest, 5 nearest of "
           "two mipmaps, 6 linear of two"},
          t.min, MinFilter::any, MinFilter::linear_mipmap_linear, kNoFilter);
  v.reserved(t.reserved);
}

template <class V>
constexpr void fields(V& v, const MaterialHeader& h, MaterialLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.finite({"alpha_cutoff", "≥ 0; for masks: what is less opaque is not drawn"}, h.alpha_cutoff);
  v.not_negative({}, h.alpha_cutoff, "a cutoff is not negative");
  v.range({"alpha", "0 opaque, 1 mask, 2 blend"}, h.alpha, AlphaMode::opaque, AlphaMode::blend, "unknown alpha mode");
  v.any({"texture_count"}, h.texture_count);
  v.flags({"flags", "1 unlit, 2 emits"}, h.flags, kAllMaterialFlags, "unknown flags of a material");
  v.records({"textures", "", "texture_count"}, l.textures, h.texture_count, [&](const Texture& t) { fields(v, t); });
  v.records({"emissive", "with flag 2; linear RGB, ≥ 0: light that is emitted, times its texture", "3"}, l.emissive,
            (h.flags & kEmits) != 0 ? 3 : 0, [&](const float& x) {
              v.finite({}, x);
              v.not_negative({}, x, "light that is emitted is not negative");
            });
}

struct ImageHeader {
  std::uint32_t name;
  std::uint32_t uri;
  std::uint32_t byte_count;
  ImageFormat format;
  std::uint8_t reserved;
  std::uint16_t fallback;
};
static_assert(sizeof(ImageHeader) == 16);

struct ImageLayout {
  Array<std::byte> data;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<ImageHeader> {
  using Type = ImageLayout;
};

template <class V>
constexpr void fields(V& v, const ImageHeader& h, ImageLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.text({"uri", "offset into NAME: as in the source, relative to it, percent-encoded; empty if it had none"}, h.uri);
  v.any({"byte_count", "0: by reference"}, h.byte_count);
  v.range({"format", "0 unknown, only without bytes; 1 PNG; 2 JPEG; 3 WebP; 4 KTX 2; 5 DDS"}, h.format,
          ImageFormat::unknown, ImageFormat::dds, "unknown format of an image");
  v.reserved(h.reserved);
  v.any({"fallback", "0: none; else 1 + which IMAG section shows the same: of formats 3 to 5, and itself of 0 to 2"},
        h.fallback);
  v.array({"data", "the source's file; nothing in it is checked", "byte_count"}, l.data, h.byte_count);
}

}  // namespace marrow::format
