// Every frame: all palettes into one texture, for meshes of any number of joints and for instanced drawing.
#include "core/check.h"
#include "core/zone.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/label.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/texture.h"

namespace marrow::gles3 {
namespace {

void upload(const Api& api, std::uint32_t y, std::uint32_t width, std::uint32_t height, const float* texels) {
  if (width == 0 || height == 0) return;
  api.TexSubImage2D(kGlTexture2d, 0, 0, static_cast<int>(y), static_cast<int>(width), static_cast<int>(height), kGlRgba,
                    kGlFloat, texels);
}

}  // namespace

Status create_palette_texture(const Api& api, const Caps& caps, std::uint32_t joints, PaletteTexture& out) {
  MARROW_REQUIRE(joints > 0);
  return make_palette_texture(api, caps, joints, "marrow: palettes", out);
}

Status make_palette_texture(const Api& api, const Caps& caps, std::uint32_t joints, const char* name,
                            PaletteTexture& out) {
  const std::uint64_t height = (std::uint64_t{3} * joints + kPaletteTextureWidth - 1) / kPaletteTextureWidth;
  if (caps.texture_size < kPaletteTextureWidth || height > caps.texture_size) return Status::unsupported;
  PaletteTexture made;
  made.capacity = joints;
  forget_errors(api);
  for (std::uint32_t& texture : made.textures)
    texture =
        make_texture(api, kGlRgba32f, kGlRgba, kGlFloat, kPaletteTextureWidth, static_cast<std::uint32_t>(height));
  api.BindTexture(kGlTexture2d, 0);
  if (api.GetError() != kGlNoError) {
    destroy(api, made);
    return Status::gl_error;
  }
  for (const std::uint32_t texture : made.textures) label(api, kGlTexture, texture, {name});
  out = made;
  return Status::ok;
}

void destroy(const Api& api, PaletteTexture& texture) {
  api.DeleteTextures(3, texture.textures);
  texture = {};
}

Status upload_palettes(const Api& api, PaletteTexture& texture, Span<const Affine> palettes) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(palettes, 1));
  if (palettes.size > texture.capacity) return Status::unsupported;
  texture.current = (texture.current + 1) % 3;
  texture.previous_count = texture.count;
  texture.count = static_cast<std::uint32_t>(palettes.size);
  const std::uint32_t rows = 3 * static_cast<std::uint32_t>(palettes.size);
  const std::uint32_t whole = rows / kPaletteTextureWidth;
  const float* const texels = palettes.data[0].rows[0];
  api.BindTexture(kGlTexture2d, texture.textures[texture.current]);
  upload(api, 0, kPaletteTextureWidth, whole, texels);
  upload(api, whole, rows % kPaletteTextureWidth, 1, texels + std::size_t{4} * kPaletteTextureWidth * whole);
  api.BindTexture(kGlTexture2d, 0);
  return Status::ok;
}

Status bind_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first, std::uint32_t joints,
                    std::uint32_t texture_unit, const Program& program) {
  const ProgramState& at = state_of(program);
  MARROW_REQUIRE(at.reads == Palettes::texture && at.palettes >= 0);
  MARROW_REQUIRE(first < texture.count && joints <= texture.count - first);
  api.ActiveTexture(kGlTexture0 + texture_unit);
  api.BindTexture(kGlTexture2d, texture.textures[texture.current]);
  api.Uniform1i(at.palettes, static_cast<int>(texture_unit));
  api.Uniform2i(at.first_row, static_cast<int>(3 * first), static_cast<int>(3 * joints));
  return Status::ok;
}

Status bind_previous_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first, std::uint32_t joints,
                             bool kept, std::uint32_t texture_unit, const Program& program) {
  const ProgramState& at = state_of(program);
  MARROW_REQUIRE(at.reads == Palettes::texture);
  const std::uint32_t count = kept ? texture.previous_count : texture.count;
  MARROW_REQUIRE(first < count && joints <= count - first);
  if (at.previous_palettes < 0) return Status::ok;
  api.ActiveTexture(kGlTexture0 + texture_unit);
  api.BindTexture(kGlTexture2d, texture.textures[(texture.current + (kept ? 2 : 0)) % 3]);
  api.Uniform1i(at.previous_palettes, static_cast<int>(texture_unit));
  return Status::ok;
}

}  // namespace marrow::gles3
